// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "sweepkit/sweep/grid_patch.hpp"

namespace sweepkit::sweep {

/// Triangulates a simple polygon given counter-clockwise: n - 2 triangles, every vertex used, none of zero
/// area unless the polygon itself has none or crosses itself.
std::vector<Triangle> triangulate_polygon(std::span<const glm::dvec2> polygon);

/// Triangulates a polygon with holes: outline 0 counter-clockwise, the holes clockwise, inside of it and
/// apart from each other. Vertices are numbered through all outlines in order; n + 2 holes - 2 triangles.
std::vector<Triangle> triangulate_region(std::span<const std::vector<glm::dvec2>> outlines);

/// Twice the signed area: positive for a counter-clockwise polygon.
double twice_signed_area(std::span<const glm::dvec2> polygon);

}  // namespace sweepkit::sweep
