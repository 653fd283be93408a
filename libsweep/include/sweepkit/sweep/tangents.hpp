// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "sweepkit/sweep/grid_patch.hpp"

namespace sweepkit::sweep {

/// A tangent for every vertex: xyz the direction in which u grows, of unit length and perpendicular to the
/// normal, w the handedness: v grows along w * cross(normal, tangent), w = 1 or -1. Vertices of equal
/// position, normal and handedness - the two sides of a seam - have the same tangent if theirs are within a
/// right angle. One that (u,v) tells nothing about gets any direction perpendicular to its normal.
/// Preconditions: the first three are of equal size, normals are of unit length.
std::vector<glm::vec4> find_tangents(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                     std::span<const glm::vec2> texcoords,
                                     std::span<const Triangle> triangles);

}  // namespace sweepkit::sweep
