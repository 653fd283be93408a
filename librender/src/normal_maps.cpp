// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Mikkelsen08], "Simulation of wrinkled surfaces revisited": normal and tangent are interpolated,
// the bitangent is their cross product times the handedness, and the frame is not made orthogonal. Departs
// from it in making each of the three unit, in the world: so do the viewers of glTF, and a scale that differs
// by direction then leaves the map's slopes as they are.
//
// Symbols: N, T, B normal, tangent, bitangent; h the handedness, times the sign of the placement's
// determinant, since a mirror turns the cross product round; (x, y, z) the map's vector, x and y times the
// strength.

#include "normal_maps.hpp"

#include <cmath>

#include "material_of.hpp"

namespace sweepkit::render {

glm::dvec3 facing_eye(const glm::dvec3& normal, const glm::dvec3& direction, const glm::dvec3& fallback) {
  const double away = glm::dot(normal, direction);
  if (!(away > 0)) return normal;
  const glm::dvec3 beside = normal - away * direction;
  const double length = glm::length(beside);
  return length > 1e-9 ? beside / length : fallback;
}

glm::dvec3 NormalMaps::normal(const Hit& hit, const glm::dvec3& direction, const SurfacePoint& point,
                              const RayDifferential& ray, glm::dvec2 uv, texmap::FilterThread& filter) const {
  const scene::Material& material = material_of(scene_, hit.object);
  const texmap::Footprint footprint = footprint_of(tracer_, hit, at_hit(tracer_, hit, direction, ray), uv);
  const glm::dvec3 texel(samplers_[*material.normal_map]->sample(footprint, filter));
  const double strength = static_cast<double>(material.normal_strength);
  const glm::dvec3 mapped = (2.0 * texel - 1.0) * glm::dvec3(strength, strength, 1);
  if (mapped.x == 0 && mapped.y == 0) return point.shading_normal;

  const TracedObject& object = tracer_.object(hit.object);
  const auto& [a, b, c] = object.mesh->triangles[hit.triangle];
  const auto& tangents = object.mesh->tangents;
  const glm::dvec4 tangent =
      hit.a * glm::dvec4(tangents[a]) + hit.b * glm::dvec4(tangents[b]) + hit.c * glm::dvec4(tangents[c]);
  const glm::dmat3 world_from_mesh(object.world_from_mesh);
  const glm::dvec3 t = world_from_mesh * glm::dvec3(tangent);
  const double length = glm::length(t);
  const glm::dvec3 n = surface_normals(tracer_, hit).shading;
  if (!(length > 0) || n == glm::dvec3(0.0)) return point.shading_normal;
  const double handedness = tangent.w * glm::determinant(world_from_mesh) < 0 ? -1 : 1;
  const glm::dvec3 bitangent = handedness * glm::cross(n, t / length);
  const double across = glm::length(bitangent);
  glm::dvec3 normal = mapped.x * (t / length) + mapped.z * n;
  if (across > 0) normal += mapped.y * (bitangent / across);
  const double size = glm::length(normal);
  if (!(size > 0)) return point.shading_normal;
  // The whole frame turns to the side that is seen, as the interpolated normal did.
  normal *= (glm::dot(n, point.shading_normal) < 0 ? -1 : 1) / size;
  return facing_eye(normal, direction, point.shading_normal);
}

}  // namespace sweepkit::render
