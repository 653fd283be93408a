// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dense_sweep.hpp"
#include "grid_deviation.hpp"
#include "morph.hpp"
#include "spine.hpp"

namespace sweepkit::sweep {

/// The grid of fewest triangles, nearly, that is within `tolerance` of the dense surface everywhere, and
/// whose columns alone take no more than `largest_share` of that. Keeps the ends, every corner and every
/// pole.
Grid fit_grid(const DenseSweep& dense, double tolerance, double largest_share);

/// Is the grid within `tolerance`, and has it cells large enough for the dense sweep to look inside of them?
bool is_well_measured(const DenseSweep& dense, const Grid& grid, double tolerance);

/// What a grid keeps of it.
Section kept_points(const Section& section, std::span<const std::size_t> columns);
Morph kept_columns(const Morph& morph, std::span<const std::size_t> columns);
Spine kept_rows(const Spine& spine, std::span<const std::size_t> rows);

}  // namespace sweepkit::sweep
