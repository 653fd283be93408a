// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "box_tree.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::render {

/// The leaf shape whose boxes the fewest rays would meet; none where the grid is smaller than every shape.
std::optional<std::uint32_t> choose_leaf_shape(const scene::MeshView& mesh, const LeafGrid& grid);

/// How many columns of children a node should have, as a power of two, when there are columns x rows of them
/// and a child spans `child` cells.
std::uint8_t choose_log_columns(const scene::MeshView& mesh, const LeafGrid& grid, std::uint32_t columns,
                                std::uint32_t rows, LeafShape child);

}  // namespace sweepkit::render
