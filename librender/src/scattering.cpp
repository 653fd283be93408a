// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Keller17], "The Iray light transport simulation and rendering system" (2017), section A.3: where
// the mirrored ray leads below the face it is lifted, and the normal is bent half way between it and the eye.
// Departs from it in lifting along the face's normal, and to a share of the face's own rise instead of onto
// the face: a ray in the face's plane would meet the next triangle edge on. What is lifted is lifted the more
// the deeper it would lead, so that neither rays nor their derivatives' bounds jump.
//
// Symbols: D the ray's direction, n the shading normal, g the face's, both on its side; w = -D;
//   R = D - 2 (D.n) n,   a = R.g,   h = kLeastRise w.g,   bent where a < h: R' = R + (h - a) g,
//   n' = (w + R' / |R'|) made unit, the normal that mirrors D to R'.
// Refraction: c = -D.n', b = sqrt(1 - eta^2 (1 - c^2)),   T = eta D + (eta c - b) n', held below the face by
// kLeastRise b in the same way.

#include "scattering.hpp"

#include "fresnel.hpp"
#include "sweepkit/strict_math.hpp"

namespace sweepkit::render {

glm::dvec3 bent_normal(const SurfacePoint& point, const glm::dvec3& direction) {
  const glm::dvec3& g = point.face_normal;
  const glm::dvec3 out = mirrored(direction, point.shading_normal);
  const double rise = glm::dot(out, g);
  const double least = -kLeastRise * glm::dot(direction, g);
  if (rise >= least) return point.shading_normal;
  return glm::normalize(glm::normalize(out + (least - rise) * g) - direction);
}

glm::dvec3 refracted(const SurfacePoint& point, const glm::dvec3& direction, const glm::dvec3& normal,
                     double eta) {
  if (eta == 1) return direction;
  const glm::dvec3& g = point.face_normal;
  const double cosine = -glm::dot(direction, normal);
  const double beyond = refracted_cosine(cosine, eta);
  const glm::dvec3 out = glm::normalize(eta * direction + (eta * cosine - beyond) * normal);
  const double sink = -glm::dot(out, g);
  const double least = kLeastRise * beyond;
  return sink >= least ? out : glm::normalize(out - (least - sink) * g);
}

Shares shares_at(const scene::Material& material, const SurfacePoint& point, const glm::dvec3& direction,
                 const glm::dvec3& normal) {
  const double eta = relative_index(material, point.is_inside);
  const double cosine = -glm::dot(direction, normal);
  const double beyond = refracted_cosine(cosine, eta);
  const double reflect = material.reflect;
  const double transmit = material.transmit;
  if (material.fresnel == scene::Fresnel::kNone)
    return beyond > 0 || eta == 1 ? Shares{reflect, transmit} : Shares{reflect + transmit, 0};
  const double f = material.fresnel == scene::Fresnel::kExact ? fresnel_exact(cosine, beyond, eta)
                                                              : fresnel_schlick(cosine, beyond, eta);
  return {reflect * f, transmit * (1 - f)};
}

}  // namespace sweepkit::render
