// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Igehy99], section 3: transfer to the plane of the hit, reflection and refraction. Departs from it
// in taking the derivative of the interpolated normal from area ratios in the mesh's own space (its eq. 13-15
// take them from the planes through the triangle's edges), which is as stable as the texture's map; and in
// carrying the derivative through what holds a ray off the face (scattering.cpp).
//
// Symbols: P the hit, D the ray's unit direction, N the face's normal, t the distance; n the unit
// interpolated normal, m the same before it is made unit; d. a derivative by one pixel.
//   transfer      dP = q - D (q.N) / (D.N),   q = dO + t dD
//   unit vector   dn = (dm - n (n.dm)) / |m|
//   reflection    R = D - 2 (D.n) n,   dR = dD - 2 ((D.n) dn + (dD.n + D.dn) n)
//   refraction    T = eta D + k n,   k = eta c - b,   c = -D.n,   b = sqrt(1 - eta^2 (1 - c^2)),
//                 dT = eta dD + dk n + k dn,   dk = eta dc - db,   dc = -(dD.n + D.dn),   db = eta^2 c dc / b
//   mapped        a normal map's normal m: dm = (n x dn) x m, the frame's rotation
//   held above    V' = (V + (h - V.N) N) made unit where V.N < h; dV + (dh - dV.N) N before it is made unit

#include "ray_differential.hpp"

#include <array>

#include "fresnel.hpp"
#include "scattering.hpp"
#include "surface_point.hpp"
#include "sweepkit/texmap/area_ratio_mapping.hpp"

namespace sweepkit::render {
namespace {

texmap::Triangle3<double> positions_of(const scene::MeshView& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]), glm::dvec3(mesh.positions[c])};
}

// A unit vector and its derivative.
struct Turning {
  glm::dvec3 vector;
  glm::dvec3 turn;
};

Turning made_unit(const glm::dvec3& vector, const glm::dvec3& moved) {
  const double length = glm::length(vector);
  const glm::dvec3 unit = vector / length;
  return {unit, (moved - glm::dot(unit, moved) * unit) / length};
}

Turning turning_mirrored(const glm::dvec3& direction, const glm::dvec3& turn, const Turning& at) {
  const auto& [n, dn] = at;
  return {mirrored(direction, n),
          turn - 2.0 * (glm::dot(direction, n) * dn + (glm::dot(turn, n) + glm::dot(direction, dn)) * n)};
}

// The interpolated normal on the side of `point`, as it turns when the hit moves by `moved`.
Turning turning_normal(const TracedObject& object, const Hit& hit, const SurfacePoint& point,
                       const glm::dvec3& moved) {
  const scene::MeshView& mesh = *object.mesh;
  const texmap::Triangle3<double> corners = positions_of(mesh, hit.triangle);
  const auto& [ia, ib, ic] = mesh.triangles[hit.triangle];
  const glm::dvec3 na(mesh.normals[ia]);
  const glm::dvec3 nb(mesh.normals[ib]);
  const glm::dvec3 nc(mesh.normals[ic]);
  const glm::dvec3 m = object.normal_to_world * (hit.a * na + hit.b * nb + hit.c * nc);
  if (!(glm::length(m) > 0)) return {point.shading_normal, glm::dvec3(0.0)};
  const texmap::Triangle3<double> about_b{corners.a - corners.b, glm::dvec3(0.0), corners.c - corners.b};
  const glm::dvec2 ratios = texmap::area_ratio_map(about_b, texmap::RightTriangle{glm::dvec2(0.0), 1, 1},
                                                   glm::dmat3(object.mesh_from_world) * moved);
  const glm::dvec3 dm = object.normal_to_world * (ratios.x * (nc - nb) + ratios.y * (na - nb));
  const double side = glm::dot(m, point.shading_normal) < 0 ? -1 : 1;
  return made_unit(side * m, side * dm);
}

// The normal of a normal map, as its frame turns it: by the rotation n x dn.
Turning turning_mapped(const Turning& normal, const glm::dvec3* mapped) {
  if (mapped == nullptr || *mapped == normal.vector) return normal;
  return {*mapped, glm::cross(glm::cross(normal.vector, normal.turn), *mapped)};
}

// The same bent as bent_normal() does.
Turning bent(const Turning& normal, const SurfacePoint& point, const glm::dvec3& direction,
             const glm::dvec3& turn) {
  const glm::dvec3& g = point.face_normal;
  const Turning out = turning_mirrored(direction, turn, normal);
  const double rise = glm::dot(out.vector, g);
  const double least = -kLeastRise * glm::dot(direction, g);
  if (rise >= least) return normal;
  const double moved = -kLeastRise * glm::dot(turn, g) - glm::dot(out.turn, g);
  const Turning lifted = made_unit(out.vector + (least - rise) * g, out.turn + moved * g);
  return made_unit(lifted.vector - direction, lifted.turn - turn);
}

Turning turning_refracted(const glm::dvec3& direction, const glm::dvec3& turn, const Turning& at,
                          const SurfacePoint& point, double eta) {
  if (eta == 1) return {direction, turn};
  const auto& [n, dn] = at;
  const double c = -glm::dot(direction, n);
  const double b = refracted_cosine(c, eta);
  const double dc = -(glm::dot(turn, n) + glm::dot(direction, dn));
  const double db = eta * eta * c * dc / b;
  const double k = eta * c - b;
  const Turning out = made_unit(eta * direction + k * n, eta * turn + (eta * dc - db) * n + k * dn);
  const glm::dvec3& g = point.face_normal;
  const double sink = -glm::dot(out.vector, g);
  const double least = kLeastRise * b;
  if (sink >= least) return out;
  return made_unit(out.vector - (least - sink) * g, out.turn - (kLeastRise * db + glm::dot(out.turn, g)) * g);
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
                          const RayDifferential& ray, const HitDifferential& at, const glm::dvec3* mapped) {
  const TracedObject& object = tracer.object(hit.object);
  const SurfacePoint point = surface_point(tracer, hit, direction);
  const auto turned = [&](const glm::dvec3& turn, const glm::dvec3& moved) {
    const Turning normal = turning_mapped(turning_normal(object, hit, point, moved), mapped);
    return turning_mirrored(direction, turn, bent(normal, point, direction, turn)).turn;
  };
  return {at.x, at.y, turned(ray.direction_x, at.x), turned(ray.direction_y, at.y)};
}

RayDifferential refracted(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction,
                          const RayDifferential& ray, const HitDifferential& at,
                          const scene::Material& material, const glm::dvec3* mapped) {
  const TracedObject& object = tracer.object(hit.object);
  const SurfacePoint point = surface_point(tracer, hit, direction);
  const double eta = relative_index(material, point.is_inside);
  const auto turned = [&](const glm::dvec3& turn, const glm::dvec3& moved) {
    const Turning own = turning_mapped(turning_normal(object, hit, point, moved), mapped);
    return turning_refracted(direction, turn, bent(own, point, direction, turn), point, eta).turn;
  };
  return {at.x, at.y, turned(ray.direction_x, at.x), turned(ray.direction_y, at.y)};
}

RayDifferential going_on(const Tracer& tracer, const MetSurface& met, const scene::Material& material,
                         const RayDifferential& ray, Step step) {
  const HitDifferential at = at_hit(tracer, met.hit, met.direction, ray);
  return step == Step::kReflected ? reflected(tracer, met.hit, met.direction, ray, at, met.normal)
                                  : refracted(tracer, met.hit, met.direction, ray, at, material, met.normal);
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
