// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <glm/glm.hpp>
#include <optional>

namespace sweepkit::scene {

/// A node's place in glTF: scale, then rotate, then translate.
struct NodeTransform {
  glm::dvec3 translation{0.0};
  glm::dvec4 rotation{0.0, 0.0, 0.0, 1.0};  ///< unit quaternion x, y, z, w
  glm::dvec3 scale{1.0};
};

/// The three steps of an affine matrix; none if it shears (glTF has no node for that). A mirroring one gets a
/// negative x scale. Precondition: not singular.
std::optional<NodeTransform> decompose(const glm::dmat4& matrix);

/// Gives a node its place; what is the identity is not written.
void place(tinygltf::Node& node, const NodeTransform& transform);

}  // namespace sweepkit::scene
