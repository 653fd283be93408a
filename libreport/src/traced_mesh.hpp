// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ray.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::report {

/// A mesh's arrays, for accelerators alone.
struct TracedMesh {
  std::vector<glm::vec3> positions;
  std::vector<sweep::Triangle> triangles;
  std::vector<sweep::GridPatch> patches;

  scene::MeshView view() const;
};

/// A tube about a trefoil knot, of about so many triangles and 60 cells round (fewer below 7,200 triangles);
/// longer than sweep() makes any.
TracedMesh trefoil_of(double triangles);

/// Eye rays of a square picture that shows a mesh within these corners, by blocks of 4 x 4 pixels.
/// Precondition: `side` is a multiple of 4.
std::vector<render::Ray> eye_rays_about(const glm::dvec3& low, const glm::dvec3& high, int side);

/// As many from anywhere on a sphere about it to anywhere in its box.
std::vector<render::Ray> incoherent_rays_about(const glm::dvec3& low, const glm::dvec3& high, int side);

}  // namespace sweepkit::report
