// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Igehy99], section 3: transfer to the plane of the hit, and reflection. Departs from it in taking
// the derivative of the interpolated normal from area ratios in the mesh's own space (its eq. 13-15 take them
// from the planes through the triangle's edges), which is as stable as the texture's map.
//
// Symbols: P the hit, D the ray's unit direction, N the face's normal, t the distance; n the unit
// interpolated normal, m the same before it is made unit; d. a derivative by one pixel.
//   transfer      dP = q - D (q.N) / (D.N),   q = dO + t dD
//   unit normal   dn = (dm - n (n.dm)) / |m|
//   reflection    R = D - 2 (D.n) n,   dR = dD - 2 ((D.n) dn + (dD.n + D.dn) n)

#include "ray_differential.hpp"

#include <array>

#include "surface_point.hpp"
#include "sweepkit/texmap/area_ratio_mapping.hpp"

namespace sweepkit::render {
namespace {

texmap::Triangle3<double> positions_of(const scene::MeshView& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]), glm::dvec3(mesh.positions[c])};
}

}  // namespace

HitDifferential at_hit(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction,
                       const RayDifferential& ray) {
  const TracedObject& object = tracer.object(hit.object);
  const texmap::Triangle3<double> corners = positions_of(*object.mesh, hit.triangle);
  // Its length does not matter.
  const glm::dvec3 normal = object.normal_to_world * glm::cross(corners.b - corners.a, corners.c - corners.a);
  const double along = glm::dot(direction, normal);
  const auto transferred = [&](const glm::dvec3& origin, const glm::dvec3& turn) {
    const glm::dvec3 moved = origin + hit.t * turn;
    return moved - (glm::dot(moved, normal) / along) * direction;
  };
  return {transferred(ray.origin_x, ray.direction_x), transferred(ray.origin_y, ray.direction_y)};
}

RayDifferential reflected(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction,
                          const RayDifferential& ray, const HitDifferential& at) {
  const TracedObject& object = tracer.object(hit.object);
  const scene::MeshView& mesh = *object.mesh;
  const texmap::Triangle3<double> corners = positions_of(mesh, hit.triangle);
  const SurfacePoint point = surface_point(tracer, hit, direction);
  const MirrorNormal mirror = mirror_normal(point, direction);

  const auto& [ia, ib, ic] = mesh.triangles[hit.triangle];
  const glm::dvec3 na(mesh.normals[ia]);
  const glm::dvec3 nb(mesh.normals[ib]);
  const glm::dvec3 nc(mesh.normals[ic]);
  const glm::dvec3 m = object.normal_to_world * (hit.a * na + hit.b * nb + hit.c * nc);
  const double length = glm::length(m);
  const glm::dvec3& n = mirror.normal;
  const double side = glm::dot(m, n) < 0 ? -1 : 1;
  const glm::dmat3 to_mesh(object.mesh_from_world);
  const texmap::Triangle3<double> about_b{corners.a - corners.b, glm::dvec3(0.0), corners.c - corners.b};
  const auto turned_normal = [&](const glm::dvec3& moved) {
    if (mirror.is_face || !(length > 0)) return glm::dvec3(0.0);
    const glm::dvec2 ratios =
        texmap::area_ratio_map(about_b, texmap::RightTriangle{glm::dvec2(0.0), 1, 1}, to_mesh * moved);
    const glm::dvec3 dm = object.normal_to_world * (ratios.x * (nc - nb) + ratios.y * (na - nb));
    return side * (dm - glm::dot(n, dm) * n) / length;
  };
  const auto turned = [&](const glm::dvec3& turn, const glm::dvec3& moved) {
    const glm::dvec3 dn = turned_normal(moved);
    return turn - 2.0 * (glm::dot(direction, n) * dn + (glm::dot(turn, n) + glm::dot(direction, dn)) * n);
  };
  return {at.x, at.y, turned(ray.direction_x, at.x), turned(ray.direction_y, at.y)};
}

texmap::Footprint footprint_of(const Tracer& tracer, const Hit& hit, const HitDifferential& at,
                               glm::dvec2 uv) {
  const TracedObject& object = tracer.object(hit.object);
  const scene::MeshView& mesh = *object.mesh;
  const auto& [a, b, c] = mesh.triangles[hit.triangle];
  const std::array<glm::dvec2, 3> texcoords = {glm::dvec2(mesh.texcoords[a]), glm::dvec2(mesh.texcoords[b]),
                                               glm::dvec2(mesh.texcoords[c])};
  const glm::dmat3 to_mesh(object.mesh_from_world);
  return texmap::footprint_from(positions_of(mesh, hit.triangle), texcoords, uv, to_mesh * at.x,
                                to_mesh * at.y);
}

}  // namespace sweepkit::render
