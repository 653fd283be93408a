// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

/// Do all these placements turn left into right? Viewers do not agree which way a normal map's y then points:
/// some take the bitangent along, others make it anew in the world.
bool all_mirror(std::span<const Object> instances);

/// A mesh turned round at its own y,z plane: the same surface under a placement that has x turned round too.
struct MirroredMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> tangents;
  std::vector<sweep::Triangle> triangles;  ///< counter-clockwise outside, as before

  explicit MirroredMesh(const MeshView& mesh);
  /// `mesh` with these arrays, which must outlive it.
  MeshView view(MeshView mesh) const;
};

}  // namespace sweepkit::scene
