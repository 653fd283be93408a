// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace sweepkit::sweep {

/// One ring of vertices about a polygon with holes: outline 0 counter-clockwise, the holes clockwise inside
/// of it, each reached by a bridge that the ring walks there and back. Vertices are numbered through all
/// outlines in order; those at a bridge's ends occur twice.
std::vector<std::uint32_t> bridge_holes(std::span<const std::vector<glm::dvec2>> outlines);

}  // namespace sweepkit::sweep
