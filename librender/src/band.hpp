// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "intersection_tree.hpp"
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
  double shade_seconds = 0;
  std::size_t row_bytes = 0;  ///< the two neighbouring rows
  std::size_t link_bytes = 0;
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
  BandPainter(const scene::Scene& scene, const scene::Plan& plan, const TreeBuilder& builder,
              const Shader& shader, texmap::TileCache& tiles, const Region& region, const Options& options);

  /// Rows first..end-1 of `image`, which is the region, and of `eye_rays`, each pixel's number of them, if it
  /// is not empty. Stops early when `is_cancelled` is set.
  BandCounts paint(texmap::Image& image, std::span<std::uint16_t> eye_rays, int first, int end,
                   const std::atomic<bool>* is_cancelled) const;

 private:
  const scene::Scene& scene_;
  const TreeBuilder& builder_;
  const Shader& shader_;
  texmap::TileCache& tiles_;
  EyeRays eye_rays_;
  Region region_;  // of the larger picture
  int supersampling_;
  std::optional<Adaptive> adaptive_;
  bool has_neighbour_rows_;
};

}  // namespace sweepkit::render
