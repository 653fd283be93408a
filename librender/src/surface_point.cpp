// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "surface_point.hpp"

#include <algorithm>
#include <limits>

namespace sweepkit::render {
namespace {

struct Corners {
  glm::dvec3 a, b, c;
};

Corners positions_of(const scene::MeshView& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]), glm::dvec3(mesh.positions[c])};
}

Corners normals_of(const scene::MeshView& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {glm::dvec3(mesh.normals[a]), glm::dvec3(mesh.normals[b]), glm::dvec3(mesh.normals[c])};
}

glm::dvec3 weighed(const Corners& corners, const Hit& hit) {
  return hit.a * corners.a + hit.b * corners.b + hit.c * corners.c;
}

// |matrix| vector, for a vector of magnitudes.
glm::dvec3 abs_product(const glm::dmat3& matrix, const glm::dvec3& vector) {
  return glm::abs(matrix[0]) * vector.x + glm::abs(matrix[1]) * vector.y + glm::abs(matrix[2]) * vector.z;
}

glm::dvec3 unit_or(const glm::dvec3& vector, const glm::dvec3& fallback) {
  const double length = glm::length(vector);
  return length > 0 ? vector / length : fallback;
}

}  // namespace

SurfacePoint surface_point(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction) {
  const TracedObject& object = tracer.object(hit.object);
  const Corners corners = positions_of(*object.mesh, hit.triangle);
  const glm::dvec3 local = weighed(corners, hit);
  SurfacePoint point;
  point.position = glm::dvec3(object.world_from_mesh * glm::dvec4(local, 1));

  const glm::dvec3 face = unit_or(glm::cross(corners.b - corners.a, corners.c - corners.a), glm::dvec3(0.0));
  const glm::dvec3 world_face = object.normal_to_world * face;
  point.face_normal = unit_or(world_face, -direction);

  // The next ray starts from this point taken back to mesh space. Interpolation, the way to the world and the
  // way back are sums of at most 3, 4 and 4 products of the magnitudes below, through an inverse that is good
  // to as many roundings: 64 roundings bound them all with room. Across the face that is |face| . moved, and
  // a step of 1 along the world's normal is one of |world_face| along the mesh's: an object that is
  // flattened a thousandfold needs no less than that.
  const glm::dvec3 size = glm::max(glm::abs(corners.a), glm::max(glm::abs(corners.b), glm::abs(corners.c)));
  const glm::dvec3 reach =
      abs_product(glm::dmat3(object.world_from_mesh), size) + glm::abs(glm::dvec3(object.world_from_mesh[3]));
  const glm::dvec3 moved = abs_product(glm::dmat3(object.mesh_from_world), reach) + size;
  const double scale = glm::length(world_face);
  point.error =
      scale > 0 ? 64 * std::numeric_limits<double>::epsilon() * glm::dot(glm::abs(face), moved) / scale : 0;

  point.shading_normal = unit_or(
      object.normal_to_world * weighed(normals_of(*object.mesh, hit.triangle), hit), point.face_normal);
  point.is_inside = glm::dot(point.face_normal, direction) > 0;
  if (point.is_inside) point.face_normal = -point.face_normal;
  if (glm::dot(point.shading_normal, point.face_normal) < 0) point.shading_normal = -point.shading_normal;
  return point;
}

SurfaceNormals surface_normals(const Tracer& tracer, const Hit& hit) {
  const TracedObject& object = tracer.object(hit.object);
  const Corners corners = positions_of(*object.mesh, hit.triangle);
  const glm::dvec3 face = glm::cross(corners.b - corners.a, corners.c - corners.a);
  return {unit_or(object.normal_to_world * unit_or(face, glm::dvec3(0.0)), glm::dvec3(0.0)),
          unit_or(object.normal_to_world * weighed(normals_of(*object.mesh, hit.triangle), hit),
                  glm::dvec3(0.0))};
}

double longest_edge(const Tracer& tracer, const Hit& hit) {
  const TracedObject& object = tracer.object(hit.object);
  const Corners corners = positions_of(*object.mesh, hit.triangle);
  const auto length = [&](const glm::dvec3& edge) {
    return glm::length(glm::dmat3(object.world_from_mesh) * edge);
  };
  return std::max(
      {length(corners.b - corners.a), length(corners.c - corners.b), length(corners.a - corners.c)});
}

bool is_on_inner_side(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction) {
  const TracedObject& object = tracer.object(hit.object);
  const Corners corners = positions_of(*object.mesh, hit.triangle);
  // As surface_point() has it, so that the two agree to the bit.
  const glm::dvec3 face = unit_or(glm::cross(corners.b - corners.a, corners.c - corners.a), glm::dvec3(0.0));
  return glm::dot(unit_or(object.normal_to_world * face, -direction), direction) > 0;
}

Ray leave_surface(const Hit& hit, const SurfacePoint& point, const glm::dvec3& start,
                  const glm::dvec3& direction) {
  Ray ray{start + point.error * point.face_normal, direction, hit.object};
  // Towards a light that only the shading normal sees the way may lead down through the face itself.
  if (glm::dot(direction, point.face_normal) > 0) ray.from_triangle = hit.triangle;
  return ray;
}

Ray pass_surface(const Hit& hit, const SurfacePoint& point, const glm::dvec3& direction) {
  return {point.position - point.error * point.face_normal, direction, hit.object, hit.triangle};
}

glm::dvec3 smooth_start(const Tracer& tracer, const Hit& hit, const SurfacePoint& point) {
  const TracedObject& object = tracer.object(hit.object);
  const Corners corners = positions_of(*object.mesh, hit.triangle);
  const Corners normals = normals_of(*object.mesh, hit.triangle);
  // From each corner the point is lifted onto the tangent plane there, on the side that is seen.
  const auto lifted = [&](const glm::dvec3& corner, const glm::dvec3& normal) {
    const glm::dvec3 at(object.world_from_mesh * glm::dvec4(corner, 1));
    glm::dvec3 n = unit_or(object.normal_to_world * normal, point.face_normal);
    if (glm::dot(n, point.face_normal) < 0) n = -n;
    return std::min(0.0, glm::dot(point.position - at, n)) * n;
  };
  return point.position - hit.a * lifted(corners.a, normals.a) - hit.b * lifted(corners.b, normals.b) -
         hit.c * lifted(corners.c, normals.c);
}

}  // namespace sweepkit::render
