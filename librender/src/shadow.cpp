// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Whitted80]: a shadow ray is dimmed by what it passes and not bent. Departs from it in dimming by
// distance inside as well.

#include "shadow.hpp"

#include "material_of.hpp"
#include "scattering.hpp"
#include "surface_point.hpp"

namespace sweepkit::render {

glm::dvec3 light_passing(const scene::Scene& scene, const Tracer& tracer, const Ray& ray, double end) {
  if (!scene.has_dimmed_shadows) return glm::dvec3(tracer.is_blocked(ray, end) ? 0.0 : 1.0);
  // Each ray starts beyond the surface that the one before met, so there are no more of them than triangles
  // along the way; the bound is for a scene of clear sheets without number.
  constexpr int kMostSurfaces = 1000;
  glm::dvec3 passing(1.0);
  Ray rest = ray;
  std::uint32_t medium = kNone;
  for (int surface = 0; surface < kMostSurfaces; ++surface) {
    const Hit hit = tracer.nearest(rest);
    if (!hit.is_hit() || !(hit.t < end)) {
      // Nothing ends where the light is in what it shines out of: an open surface holds no volume.
      if (medium != kNone && end < kNoEnd) passing *= absorbed(material_of(scene, medium), end);
      return passing;
    }
    const scene::Material& material = material_of(scene, hit.object);
    if (!(material.transmit > 0)) return glm::dvec3(0.0);
    const SurfacePoint point = surface_point(tracer, hit, rest.direction);
    if (point.is_inside) medium = hit.object;
    if (medium != kNone) passing *= absorbed(material_of(scene, medium), hit.t);
    passing *= static_cast<double>(material.transmit);
    medium = point.is_inside ? kNone : hit.object;
    end -= hit.t;
    rest = pass_surface(hit, point, rest.direction);
  }
  return glm::dvec3(0.0);
}

}  // namespace sweepkit::render
