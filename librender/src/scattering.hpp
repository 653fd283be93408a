// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "surface_point.hpp"
#include "sweepkit/scene/material.hpp"

namespace sweepkit::render {

/// What of the light at the other end of a mirrored and of a refracted ray a node hands on.
struct Shares {
  double mirrored = 0;
  double refracted = 0;
};

inline glm::dvec3 mirrored(const glm::dvec3& direction, const glm::dvec3& normal) {
  return direction - 2 * glm::dot(direction, normal) * normal;
}

/// Does a mirrored or refracted ray leave this material at all?
inline bool scatters(const scene::Material& material) {
  return material.reflect > 0 || material.transmit > 0;
}

/// The index of refraction on the ray's side over the one beyond. What transmits nothing is seen from the air
/// on both sides.
inline double relative_index(const scene::Material& material, bool is_inside) {
  const auto ior = static_cast<double>(material.ior);
  return is_inside && material.transmit > 0 ? ior : 1 / ior;
}

/// How far the interpolated normal may lead a ray towards the face: a mirrored ray rises over it by no less
/// than this share of what the face itself would give, a refracted one sinks below by no less than this share
/// of its cosine to the normal. It begins where the normal is off the face's by 7/16 of the
/// angle between ray and face.
inline constexpr double kLeastRise = 0.125;

/// The shading normal, bent towards the face where a ray mirrored at it would lead into the surface, and as
/// far as that takes [Keller17]. The same on both sides of where the bend begins. `direction` is the unit
/// direction of the ray that arrives.
glm::dvec3 bent_normal(const SurfacePoint& point, const glm::dvec3& direction);

/// Where Snell's law sends the ray beyond the surface; unit. Precondition: no total reflection. With eta = 1
/// it goes straight on, to the bit.
glm::dvec3 refracted(const SurfacePoint& point, const glm::dvec3& direction, const glm::dvec3& normal,
                     double eta);

/// The two shares of `material` for a ray along `direction`, met at `normal` (bent_normal()).
Shares shares_at(const scene::Material& material, const SurfacePoint& point, const glm::dvec3& direction,
                 const glm::dvec3& normal);

/// What is left of light after so many metres inside.
inline glm::dvec3 absorbed(const scene::Material& material, double metres) {
  return glm::exp(-metres * glm::dvec3(material.absorption));
}

}  // namespace sweepkit::render
