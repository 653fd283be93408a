// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "integral_table.hpp"
#include "spline_pieces.hpp"
#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::texmap {

/// Adds to `total`, in words, a texture's texels over one piece of each axis as the two weigh them. The table
/// is of `order`, as the pieces are, and its carries are made. Exact sums, weighed in double.
void add_block(const IntegralTable& table, int order, const AxisPiece& across, const AxisPiece& down,
               TileReader& reader, std::array<double, 3>& total);

}  // namespace sweepkit::texmap
