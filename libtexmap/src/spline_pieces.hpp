// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::texmap {

/// Most boxes that are convolved with each other.
inline constexpr int kMostOrder = 3;

/// Where a filter of order n weighs an axis: n boxes of `width` convolved, which is a B-spline over
/// [left, left + n width]. In texels; width > 0.
struct SplineInterval {
  double left;
  double width;
};

/// Neighbouring columns that lie in one tile of a table.
struct ColumnRun {
  int tile;
  int offset;  ///< of the first in the tile
  int first;   ///< of them among the piece's columns
  int count;
};

/// A stretch of an axis inside the image and how it is weighed: by the columns of a table of n-fold sums over
/// the stretch alone. Column i sums texels 0..i-1; columns up to 0 are zero.
struct AxisPiece {
  /// n that anchor, the last at the stretch's beginning, where the sums over the stretch are zero; then the
  /// weighed ones. At most the n + 1 knots, the beginning and the end take n + 1 columns each.
  static constexpr int kMostColumns = (kMostOrder + 3) * (kMostOrder + 1);
  int count = 0;
  int zeros = 0;      ///< leading columns that are zero
  int run_count = 0;  ///< over the others
  std::array<int, kMostColumns> column{};
  std::array<double, kMostColumns> weight{};
  std::array<ColumnRun, kMostColumns> runs{};
};

/// n! w^n: what all weights of an axis come to.
double spline_total(int order, double width);

/// Cuts an axis of `size` texels under its wrap into pieces of at most `longest` texels whose weighed sums
/// add up to the filter's value. `interval` lies within 2^52 texels.
void cut_into_pieces(const SplineInterval& interval, int order, int size, Wrap wrap, int longest,
                     std::vector<AxisPiece>& pieces);

/// spline_total() times the filter's weights of texels first, first + 1, ...
void weigh_texels(const SplineInterval& interval, int order, int first, std::span<double> weights);

}  // namespace sweepkit::texmap
