// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "intersection_tree.hpp"
#include "pixel_error.hpp"
#include "row_buffers.hpp"
#include "shading.hpp"
#include "sweepkit/render/render.hpp"

namespace sweepkit::render {

struct RefinementCounts {
  std::uint64_t pixels = 0;  ///< with more than one ray
  std::uint64_t rays = 0;    ///< those more
  std::size_t bytes = 0;
};

/// Compares the pixels of a band with their neighbours, row by row as they come, and shades those that differ
/// by more rays.
class RefinedRows {
 public:
  /// Of rows of `width` pixels from `first`. The pixels at either end are there to be compared with. Without
  /// `options` nothing is refined; with `tells_errors` what is known of each pixel's error is kept.
  RefinedRows(const scene::Scene& scene, const TreeBuilder& builder, const Shader& shader,
              const EyeRays& eye_rays, const std::optional<Adaptive>& options, bool tells_errors, int first,
              std::size_t width);

  /// The next row: the middle one of `rows`, whose trees begin `border` pixels before `first`, and its
  /// colours by one ray a pixel. It is compared in itself and with the row before.
  void add(const RowBuffers& rows, int border, std::span<const TreeColor> colors);

  /// Row y of the picture, the last but one that was added: now compared on all sides. Good until the next
  /// one is added.
  std::span<const glm::dvec4> finish(int y, texmap::FilterThread& filter, RayCounts& rays,
                                     ShadingCounts& shading);
  /// Of the pixels of that row, how many eye rays they had.
  std::span<const std::uint32_t> eye_rays() const { return eye_ray_counts_; }

  /// And what is known of their errors, where it is wanted.
  std::span<const PixelError> errors() const { return errors_; }

  RefinementCounts counts() const;

 private:
  struct Row {
    std::vector<glm::dvec4> colors;
    std::vector<glm::dvec3> plain;  // TreeColor::plain
    std::vector<std::uint8_t> is_marked;
    std::vector<double> variance;  // of a pixel half its own and half its least like neighbour
  };
  // Pixel i of a row, whose tree is `a` of its trees, and j of one, beside it.
  void compare(const TreeRow& trees_a, std::size_t a, Row& row_a, std::size_t i, const TreeRow& trees_b,
               std::size_t b, Row& row_b, std::size_t j) const;
  struct Refined {
    glm::dvec4 color;
    int rays;
    double squared_error;  // expected
  };
  // `expected`: the variance of the above.
  Refined refine(int x, int y, double expected, texmap::FilterThread& filter, RayCounts& rays,
                 ShadingCounts& shading);

  const scene::Scene& scene_;
  const TreeBuilder& builder_;
  const Shader& shader_;
  const EyeRays& eye_rays_;
  bool refines_;
  Adaptive options_;
  int first_;
  Row above_;
  Row row_;
  TreeRow samples_;  // of one pixel
  std::vector<std::uint32_t> eye_ray_counts_;
  std::vector<PixelError> errors_;
  RefinementCounts counts_;
};

}  // namespace sweepkit::render
