// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

/// An object in the world, whatever its placement and its mesh's origin are.
struct PlacedSurface {
  std::vector<glm::dvec3> positions;       ///< each place once, in the order of the vertices
  std::vector<std::uint32_t> places;       ///< by vertex of the mesh: which position is its
  std::vector<glm::vec3> normals;          ///< by vertex, of length 1
  std::vector<sweep::Triangle> triangles;  ///< of vertices; turned round where the placement mirrors. Those
                                           ///< with two corners in one place are left out
};

/// Throws InputError where no triangle is left.
PlacedSurface place_surface(const MeshView& mesh, const Object& object);

}  // namespace sweepkit::scene
