// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>

#include "eye_rays.hpp"
#include "intersection_tree.hpp"
#include "shading.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::render {

/// Colours of some rays of a pixel, added up.
struct ColorSums {
  glm::dvec4 sum{0.0};
  glm::dvec4 squares{0.0};
};

/// Draws single pixels by rays through places of their own, many pixels at a time.
class PixelSampler {
 public:
  PixelSampler(const TreeBuilder& builder, const Shader& shader, const EyeRays& eye_rays,
               texmap::TileCache& tiles, const Region& region, const Options& options)
      : builder_(builder),
        shader_(shader),
        eye_rays_(eye_rays),
        tiles_(tiles),
        region_(region),
        options_(options) {}

  /// A thread's own work on one pixel after another.
  class Thread {
   public:
    explicit Thread(const PixelSampler& sampler) : sampler_(sampler), filter_(sampler.tiles_) {}
    /// The rays through `places`, in the unit square, of the pixel with this place in the region row by row;
    /// each one's textures averaged over a square of `side` pixels.
    void add(ColorSums& sums, std::size_t pixel, std::span<const glm::dvec2> places, double side);

    RayCounts rays;
    ShadingCounts shading;

   private:
    const PixelSampler& sampler_;
    TreeRow row_;
    texmap::FilterThread filter_;
  };

  struct Counts {
    RayCounts rays;
    ShadingCounts shading;
  };
  /// work(thread, i) for all i below `count`, in any order; what it must not do is depend on that. Adds to
  /// `counts`. Throws Cancelled.
  void for_each(std::size_t count, const std::function<void(Thread&, std::size_t)>& work,
                Counts& counts) const;

  const Region& region() const { return region_; }

 private:
  const TreeBuilder& builder_;
  const Shader& shader_;
  const EyeRays& eye_rays_;
  texmap::TileCache& tiles_;
  Region region_;
  const Options& options_;
};

}  // namespace sweepkit::render
