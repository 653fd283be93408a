// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace sweepkit::texmap {

inline constexpr std::uint32_t kNoTwin = 0xFFFFFFFF;

/// The neighbours of a triangle list. Edge 3 t + k runs from corner k of triangle t to the next; its twin is
/// the edge of another triangle between the same two places, the other way, or kNoTwin: at a border, where
/// the neighbour is turned over, and for what is left over where more than two triangles meet. Corners of
/// equal position are one place.
std::vector<std::uint32_t> find_twins(std::span<const glm::vec3> positions,
                                      std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace sweepkit::texmap
