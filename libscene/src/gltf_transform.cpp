// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_transform.hpp"

#include <glm/gtc/quaternion.hpp>

namespace sweepkit::scene {

std::optional<NodeTransform> decompose(const glm::dmat4& matrix) {
  glm::dmat3 axes(matrix);
  NodeTransform transform;
  transform.translation = glm::dvec3(matrix[3]);
  if (axes == glm::dmat3(1.0)) return transform;
  for (int i = 0; i < 3; ++i) transform.scale[i] = glm::length(axes[i]);
  if (glm::determinant(axes) < 0) transform.scale.x = -transform.scale.x;
  for (int i = 0; i < 3; ++i) axes[i] /= transform.scale[i];
  // A product of three rotations and a scale in double is off by a few units in the last place, 1e-15; a
  // shear that anyone wants is far more than 1e-9.
  const double shear = std::abs(glm::dot(axes[0], axes[1])) + std::abs(glm::dot(axes[1], axes[2])) +
                       std::abs(glm::dot(axes[2], axes[0]));
  if (!(shear < 1e-9)) return std::nullopt;
  const glm::dquat rotation = glm::normalize(glm::quat_cast(axes));
  transform.rotation = {rotation.x, rotation.y, rotation.z, rotation.w};
  return transform;
}

void place(tinygltf::Node& node, const NodeTransform& transform) {
  const auto& [t, r, s] = transform;
  if (t != glm::dvec3(0.0)) node.translation = {t.x, t.y, t.z};
  if (r != glm::dvec4(0, 0, 0, 1)) node.rotation = {r.x, r.y, r.z, r.w};
  if (s != glm::dvec3(1.0)) node.scale = {s.x, s.y, s.z};
}

}  // namespace sweepkit::scene
