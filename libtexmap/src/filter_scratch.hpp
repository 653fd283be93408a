// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "axis_runs.hpp"
#include "ellipse_rows.hpp"
#include "spline_pieces.hpp"
#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::texmap {

/// What one thread needs while it filters.
struct FilterScratch {
  TileReader tiles;
  std::vector<AxisRun> columns;
  std::vector<AxisRun> rows;
  Spans spans;

  TileReader tables;  ///< their tiles are thrice as large
  std::vector<AxisPiece> across;
  std::vector<AxisPiece> down;

  explicit FilterScratch(TileCache& cache) : tiles(cache, 128), tables(cache, 32) {}
};

}  // namespace sweepkit::texmap
