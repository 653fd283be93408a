// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"
#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::render {

/// What a ray that escapes brings: the scene's background, a colour or a picture of everything around.
class Environment {
 public:
  Environment(const scene::Scene& scene, const scene::Plan& plan, texmap::Filter filter,
              texmap::TileCache& tiles);

  /// Does a lookup need the ray's derivatives? Else any will do.
  bool reads_differentials() const { return sampler_ && texmap::reads_footprint(filter_); }
  bool is_picture() const { return sampler_.has_value(); }

  /// Along a unit direction that turns by `turn_x` for a step of one pixel to the right, and by `turn_y`
  /// down.
  glm::dvec3 color(const glm::dvec3& direction, const glm::dvec3& turn_x, const glm::dvec3& turn_y,
                   texmap::FilterThread& thread) const;

  std::size_t table_bytes() const { return sampler_ ? sampler_->table_bytes() : 0; }

 private:
  glm::dvec3 background_;
  texmap::Filter filter_;
  glm::dvec2 size_{0.0};
  std::optional<texmap::TextureSampler> sampler_;
};

}  // namespace sweepkit::render
