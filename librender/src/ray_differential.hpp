// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "ray.hpp"
#include "sweepkit/scene/material.hpp"
#include "sweepkit/texmap/footprint.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

/// How a ray changes for a step of one pixel to the right (x) and one down (y): the derivatives of its origin
/// and of its unit direction [Igehy99].
struct RayDifferential {
  glm::dvec3 origin_x{0.0};
  glm::dvec3 origin_y{0.0};
  glm::dvec3 direction_x{0.0};
  glm::dvec3 direction_y{0.0};
};

/// The same of the point where it meets a triangle, on the triangle's plane. Not finite where the ray lies in
/// that plane.
struct HitDifferential {
  glm::dvec3 x;
  glm::dvec3 y;
};

/// Of a ray along `direction` that meets `hit`.
HitDifferential at_hit(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction,
                       const RayDifferential& ray);

/// Of the ray that is mirrored there: the normal that it is mirrored at turns with the hit. `normal` is the
/// one of a normal map, if there is one: it turns as the frame does that it is given in. What the map's own
/// unevenness adds is left out.
RayDifferential reflected(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction,
                          const RayDifferential& ray, const HitDifferential& at,
                          const glm::dvec3* normal = nullptr);

/// Of the ray that goes on through the surface. Not finite at the critical angle. Precondition: no total
/// reflection.
RayDifferential refracted(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction,
                          const RayDifferential& ray, const HitDifferential& at,
                          const scene::Material& material, const glm::dvec3* normal = nullptr);

enum class Step { kReflected, kRefracted };

/// A hit, the ray that it was met along, and the normal of a normal map (reflected()).
struct MetSurface {
  Hit hit;
  glm::dvec3 direction;
  const glm::dvec3* normal = nullptr;
};

/// Of the ray that goes on from there, when the one that arrives has `ray`.
RayDifferential going_on(const Tracer& tracer, const MetSurface& met, const scene::Material& material,
                         const RayDifferential& ray, Step step);

/// What the pixel covers of the texture about `uv`, (u,v) of the hit.
texmap::Footprint footprint_of(const Tracer& tracer, const Hit& hit, const HitDifferential& at,
                               glm::dvec2 uv);

}  // namespace sweepkit::render
