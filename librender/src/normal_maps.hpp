// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ray_differential.hpp"
#include "surface_point.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

/// By Scene::textures; none where the texture is computed, or not used.
using Samplers = std::vector<std::optional<texmap::TextureSampler>>;

/// The normals that normal maps give: mapped x along the tangent, y along the bitangent, z along the
/// interpolated normal, all three in the world and of unit length. The map is filtered over what the ray's
/// differential says that the pixel covers, since rays leave a hit before its neighbours are known.
class NormalMaps {
 public:
  NormalMaps(const scene::Scene& scene, const Tracer& tracer, const Samplers& samplers)
      : scene_(scene), tracer_(tracer), samplers_(samplers) {}

  /// Unit, and not turned away from the eye: a normal that is turned past a right angle is turned back to it,
  /// the shortest way. Where the map says (0, 0, 1) it is the point's own, to the bit. Precondition: the
  /// hit's material has a normal map, `uv` are the hit's.
  glm::dvec3 normal(const Hit& hit, const glm::dvec3& direction, const SurfacePoint& point,
                    const RayDifferential& ray, glm::dvec2 uv, texmap::FilterThread& filter) const;

 private:
  const scene::Scene& scene_;
  const Tracer& tracer_;
  const Samplers& samplers_;
};

/// `normal` if it is on the side of the ray that arrives along `direction`, else turned back until it is at
/// right angles to it. Both are unit. `fallback` stands for a normal along the ray itself, which could be
/// turned back any way.
glm::dvec3 facing_eye(const glm::dvec3& normal, const glm::dvec3& direction, const glm::dvec3& fallback);

}  // namespace sweepkit::render
