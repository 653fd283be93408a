// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace sweepkit::texmap {

/// For each triangle the edge (as find_twins() numbers them) across which it is paired, or kNoTwin. No two
/// neighbours are both left alone, and of a closed mesh none is unless the search for a partner grows beyond
/// its bound.
std::vector<std::uint32_t> pair_triangles(std::span<const glm::vec3> positions,
                                          std::span<const std::array<std::uint32_t, 3>> triangles,
                                          std::span<const std::uint32_t> twins);

}  // namespace sweepkit::texmap
