// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [BlinnNewell76]: the direction of a ray that meets nothing is looked up in a picture by latitude
// and longitude. Departs from it in filtering over what the ray's derivatives [Igehy99] say a pixel covers,
// straight from the eye, mirrored or refracted alike.

#include "environment.hpp"

#include "sweepkit/texmap/latitude_longitude.hpp"

namespace sweepkit::render {

Environment::Environment(const scene::Scene& scene, const scene::Plan& plan, texmap::Filter filter,
                         texmap::TileCache& tiles)
    : background_(scene.background), filter_(filter) {
  if (!plan.needs_part(scene::Part::kEnvironment)) return;
  size_ = texmap::size_of(*scene.environment);
  // The textures' own tiles have the numbers before.
  sampler_.emplace(texmap::over_sphere(*scene.environment), filter, tiles,
                   static_cast<std::uint32_t>(scene.textures.size()));
}

glm::dvec3 Environment::color(const glm::dvec3& direction, const glm::dvec3& turn_x, const glm::dvec3& turn_y,
                              texmap::FilterThread& thread) const {
  if (!sampler_) return background_;
  return glm::dvec3(sampler_->sample(texmap::over_sphere(direction, turn_x, turn_y, size_), thread));
}

}  // namespace sweepkit::render
