// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "sweepkit/sweep/grid_patch.hpp"

namespace sweepkit::scene {

/// What KHR_mesh_quantization lets stand in a file, each four-byte aligned as glTF wants it.
using ShortPosition = std::array<std::uint16_t, 4>;  ///< the last is padding
using ByteVector = std::array<std::int8_t, 4>;       ///< the last is padding, or a tangent's handedness
using ShortTexcoord = std::array<std::uint16_t, 2>;

/// The grid that a mesh's positions are rounded to. One step for the three axes, so that the node that undoes
/// it scales by one number: it shears under no instance and turns no normal.
struct PositionGrid {
  glm::dvec3 offset{0.0};
  double step = 1;  ///< position = offset + step * whole numbers
};

/// The least corner of the positions' box, and its longest side in 2^bits - 1 steps. What is one point has
/// step 1. Precondition: not empty, finite, bits 1 to 16.
PositionGrid position_grid(std::span<const glm::vec3> positions, int bits);

/// The fewest bits, 8 to 14, whose step is at most 1/32 of the triangles' shortest edges on average. Finer
/// would keep digits of how the mesh stands in for its curves. Precondition: not empty.
int bits_for_cells(std::span<const glm::vec3> positions, std::span<const sweep::Triangle> triangles);

/// The nearest place of the grid: off by half a step an axis at most, positions of the same bits stay so.
std::vector<ShortPosition> to_grid(std::span<const glm::vec3> positions, const PositionGrid& grid);

/// Those triangles whose corners are three places of the grid: the others have no area left. What bounds a
/// body still does: an edge that collapses takes both its sides along.
std::vector<sweep::Triangle> with_area(std::span<const sweep::Triangle> triangles,
                                       std::span<const ShortPosition> positions);

/// Unit vectors in steps of 1/127: off by 1/254 an axis.
std::vector<ByteVector> to_bytes(std::span<const glm::vec3> vectors);
std::vector<ByteVector> to_bytes(std::span<const glm::vec4> vectors);

/// (u,v) in steps of 1/65535: off by half of that. None where any is beyond 0 and 1.
std::optional<std::vector<ShortTexcoord>> to_shorts(std::span<const glm::vec2> texcoords);

}  // namespace sweepkit::scene
