// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eye_rays.hpp"
#include "intersection_tree.hpp"
#include "sweepkit/render/layer.hpp"
#include "sweepkit/scene/scene.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

/// Fills the layers of a picture, row by row.
class LayerPainter {
 public:
  /// `eye_rays` has one ray a pixel of the picture. All must outlive this.
  LayerPainter(const scene::Scene& scene, const Tracer& tracer, const TreeBuilder& builder,
               const EyeRays& eye_rays, std::vector<PictureLayer>& layers)
      : scene_(scene), tracer_(tracer), builder_(builder), eye_rays_(eye_rays), layers_(layers) {}

  bool is_needed() const { return !layers_.empty(); }

  /// Row `row` of the layers: the picture's pixels from (first_x, y) on. `trees` are the row's own, where
  /// they were grown through the pixels' middles; else none, and a ray a pixel is traced. `rays` is how many
  /// eye rays each pixel's colour took, one number a pixel. Returns how many rays were traced. Any number of
  /// threads, each at its own rows.
  std::uint64_t fill(int row, int first_x, int y, const TreeRow* trees,
                     std::span<const std::uint32_t> rays) const;

 private:
  void write(Layer layer, const Hit& hit, const glm::dvec3& direction, int x, int y, float* out) const;

  const scene::Scene& scene_;
  const Tracer& tracer_;
  const TreeBuilder& builder_;
  const EyeRays& eye_rays_;
  std::vector<PictureLayer>& layers_;
};

}  // namespace sweepkit::render
