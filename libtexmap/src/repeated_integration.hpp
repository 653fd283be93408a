// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <vector>

#include "filter_scratch.hpp"
#include "integral_table.hpp"
#include "pyramid.hpp"
#include "spline_pieces.hpp"
#include "sweepkit/texmap/footprint.hpp"
#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::texmap {

/// Filters a texture by repeated integration [Heckbert86]: n boxes convolved along each axis, in a time that
/// does not depend on their width, any box in any place. Integer textures come out exact for integer corners
/// and to 1e-9 of a level else; float ones to less than 1e-6 of their range.
class RepeatedIntegration {
 public:
  /// The texture's tables share `id` with its pyramid. Nothing is summed up before the first lookup.
  RepeatedIntegration(const Pyramid& pyramid, Wrap wrap, int order, TileCache& cache, std::uint32_t id);

  /// Over a pixel: n boxes with the variance of a tent of one pixel each way along u and along v.
  glm::vec3 over_pixel(const Footprint& footprint, FilterScratch& scratch) const;

  /// With a box as support: n boxes of an n-th of it; for n = 1 its mean. Boxes that are infinite, NaN or
  /// beyond 2^52 texels give the mean of the whole texture.
  glm::vec3 over_box(const UvBox& box, FilterScratch& scratch) const;

  /// Memory held besides tiles, once no lookup is going on.
  std::size_t bytes() const;

 private:
  struct Tables {
    FixedPoint fixed_point;
    int longest = 0;  // of a piece
    std::vector<std::unique_ptr<const IntegralTable>> levels;
  };
  const Tables& tables() const;
  template <class Texel>
  std::array<double, 3> weigh(const SplineInterval& x, const SplineInterval& y, FilterScratch& scratch) const;
  glm::vec3 filter(SplineInterval x, SplineInterval y, FilterScratch& scratch) const;
  int level_for(const SplineInterval& x, const SplineInterval& y, int longest) const;

  const Pyramid& pyramid_;
  Wrap wrap_;
  int order_;
  TileCache& cache_;
  std::uint32_t id_;
  mutable std::once_flag once_;
  mutable Tables tables_;
};

}  // namespace sweepkit::texmap
