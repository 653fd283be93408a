// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::sweep {

// OpenMesh keeps each property in one contiguous vector of VectorT<float, N>, which is an array of N floats
// like glm's vector; the spans below look at the same storage under glm's name.
static_assert(sizeof(OpenMesh::Vec3f) == sizeof(glm::vec3) && sizeof(OpenMesh::Vec2f) == sizeof(glm::vec2));

std::span<const glm::vec3> Mesh::positions() const {
  return {reinterpret_cast<const glm::vec3*>(points()), n_vertices()};
}

}  // namespace sweepkit::sweep
