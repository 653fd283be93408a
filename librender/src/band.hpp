// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <span>

#include "intersection_tree.hpp"
#include "layers.hpp"
#include "refinement.hpp"
#include "shading.hpp"
#include "supersampling.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/texmap/image.hpp"
#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::render {

/// What a band of rows cost.
struct BandCounts {
  RayCounts rays;
  ShadingCounts shading;
  RefinementCounts refinement;
  std::uint64_t layer_rays = 0;
  double shade_seconds = 0;
  std::size_t row_bytes = 0;  ///< the two neighbouring rows
  std::size_t reflection_bytes = 0;
  std::size_t refraction_bytes = 0;
  std::size_t share_bytes = 0;
  std::size_t normal_bytes = 0;
  std::size_t texcoord_bytes = 0;
  std::size_t visibility_bytes = 0;
  std::size_t shrink_bytes = 0;

  void add(const BandCounts& other);
};

/// Draws bands of rows: the unit of parallel work. Within a band the three row buffers shift by one row at a
/// time (the paper's 3.2.3); the rows just outside it are traced again by the band next to it, so bands need
/// nothing of each other and the picture does not depend on how it is cut. Where pixels are compared with
/// their neighbours a band also shades a row more on either side, and a pixel more at either end.
class BandPainter {
 public:
  /// `eye_rays` and `region` are the picture's and its part's, both as large as the supersampling makes them
  /// in `eye_rays` and not yet in `region`. `errors`: one for each pixel of the region, or none; without
  /// supersampling only.
  BandPainter(const scene::Scene& scene, const scene::Plan& plan, const EyeRays& eye_rays,
              const TreeBuilder& builder, const Shader& shader, const LayerPainter& layers,
              texmap::TileCache& tiles, const Region& region, int supersampling,
              const std::optional<Adaptive>& adaptive, std::span<PixelError> errors);

  /// Rows first..end-1 of `image`, which is the region, and of the layers. An image of four channels has the
  /// background left out: colours are multiplied by the share of the pixel that objects cover, which is the
  /// fourth. Stops early when `is_cancelled` is set.
  BandCounts paint(texmap::Image& image, int first, int end, const std::atomic<bool>* is_cancelled) const;

 private:
  const scene::Scene& scene_;
  const TreeBuilder& builder_;
  const Shader& shader_;
  const LayerPainter& layers_;
  texmap::TileCache& tiles_;
  const EyeRays& eye_rays_;
  Region region_;  // of the larger picture
  int supersampling_;
  std::optional<Adaptive> adaptive_;
  std::span<PixelError> errors_;  // none: not wanted
  bool has_neighbour_rows_;
};

}  // namespace sweepkit::render
