// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "axis_runs.hpp"
#include "spline_pieces.hpp"
#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::texmap {

/// The part of a row of texels that a footprint covers, in texels from the left of the footprint's box.
struct Span {
  int first;
  int last;
  float top;     ///< what is left of 1 in this row where the weight is greatest
  float middle;  ///< where that is
};

/// What one thread needs while it filters.
struct FilterScratch {
  TileReader tiles;
  std::vector<AxisRun> columns;
  std::vector<AxisRun> rows;
  std::vector<Span> spans;

  TileReader tables;  ///< their tiles are thrice as large
  std::vector<AxisPiece> across;
  std::vector<AxisPiece> down;

  explicit FilterScratch(TileCache& cache) : tiles(cache, 128), tables(cache, 32) {}
};

}  // namespace sweepkit::texmap
