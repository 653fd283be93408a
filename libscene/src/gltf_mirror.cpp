// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_mirror.hpp"

#include <algorithm>

namespace sweepkit::scene {

bool all_mirror(std::span<const Object> instances) {
  return std::ranges::all_of(instances, [](const Object& object) {
    return glm::determinant(glm::dmat3(object.world_from_object)) < 0;
  });
}

MirroredMesh::MirroredMesh(const MeshView& mesh)
    : positions(mesh.positions.begin(), mesh.positions.end()),
      normals(mesh.normals.begin(), mesh.normals.end()),
      tangents(mesh.tangents.begin(), mesh.tangents.end()),
      triangles(mesh.triangles.begin(), mesh.triangles.end()) {
  for (glm::vec3& position : positions) position.x = -position.x;
  for (glm::vec3& normal : normals) normal.x = -normal.x;
  // The cross product of normal and tangent turns round besides.
  for (glm::vec4& tangent : tangents) tangent = {-tangent.x, tangent.y, tangent.z, -tangent.w};
  for (sweep::Triangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
}

MeshView MirroredMesh::view(MeshView mesh) const {
  mesh.positions = positions;
  mesh.normals = normals;
  mesh.tangents = tangents;
  mesh.triangles = triangles;
  return mesh;
}

}  // namespace sweepkit::scene
