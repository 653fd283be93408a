// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dense_sweep.hpp"

namespace sweepkit::sweep {

/// Columns (an outline) and rows of a dense sweep that are kept.
struct Grid {
  std::vector<std::vector<std::size_t>> columns;
  std::vector<std::size_t> rows;
  double deviation = 0;  ///< the largest distance found between the dense surface and the grid's triangles
};

std::size_t cells_of(const Grid& grid);

/// How far along the polygon of its points each column of a section is.
std::vector<double> chord_lengths(const Section& section);

/// Appends places evenly by length between two of them, the first included.
void add_parts(std::span<const double> lengths, std::size_t first, std::size_t last, std::size_t parts,
               std::vector<std::size_t>& places);

/// The largest distance found of the dense surface from the triangles of its cells. `lengths`:
/// chord_lengths() of every outline.
double deviation_of(const Grid& grid, const DenseSweep& dense,
                    const std::vector<std::vector<double>>& lengths);

}  // namespace sweepkit::sweep
