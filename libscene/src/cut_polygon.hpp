// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace sweepkit::scene {

/// A polygon in space, nearly flat, cut into n - 2 triangles of its corners with its own winding. A
/// quadrilateral is cut along the diagonal that keeps it inside, the shorter one where both do. What crosses
/// itself is cut somehow. Precondition: at least 3 corners.
std::vector<std::array<std::uint32_t, 3>> cut_polygon(std::span<const glm::dvec3> corners);

}  // namespace sweepkit::scene
