// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "gltf_quantize.hpp"
#include "sweepkit/sweep/grid_patch.hpp"

namespace sweepkit::scene {

/// What EXT_meshopt_compression unpacks to the same bytes. Precondition: whole items, whose size is a
/// multiple of four up to 256.
std::vector<std::byte> pack_vertices(std::span<const std::byte> items, std::size_t item_bytes);

/// The same triangles in the same order; each may begin at another of its corners.
std::vector<std::byte> pack_triangles(std::span<const sweep::Triangle> triangles, std::size_t vertex_count);

/// Unit vectors on the octahedron in steps of 1/127, as the filter OCTAHEDRAL takes them: what it makes of
/// them is off by (2 sqrt(3) + 1) / 254 a part at most, and unit to the rounding of bytes.
std::vector<ByteVector> to_octahedron(std::span<const glm::vec3> vectors);
std::vector<ByteVector> to_octahedron(std::span<const glm::vec4> vectors);

/// Floats as whole numbers of 2^-16, as the filter EXPONENTIAL takes them: off by 2^-17 at most. None where
/// one is over what 24 bits hold (128).
std::optional<std::vector<std::array<std::uint32_t, 2>>> to_exponential(std::span<const glm::vec2> values);

/// Triangles in an order in which neighbours follow each other.
std::vector<sweep::Triangle> in_cache_order(std::span<const sweep::Triangle> triangles,
                                            std::size_t vertex_count);

}  // namespace sweepkit::scene
