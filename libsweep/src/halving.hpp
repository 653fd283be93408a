// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "stations.hpp"

namespace sweepkit::sweep {

/// How rough the halves of pieces are that are divided into cells: the largest `error(i)` of the stations i
/// inside each.
struct HalfErrors {
  std::vector<double> left, right;

  template <class Error>
  HalfErrors(const std::vector<int>& cells, const Error& error)
      : left(cells.size(), 0.0), right(cells.size(), 0.0) {
    std::size_t first = 0;
    for (std::size_t piece = 0; piece < cells.size(); ++piece) {
      const auto count = static_cast<std::size_t>(cells[piece]);
      for (std::size_t k = 1; k < count; ++k) {
        const double here = error(first + k);
        if (2 * k <= count) left[piece] = std::max(left[piece], here);
        if (2 * k >= count) right[piece] = std::max(right[piece], here);
      }
      first += count;
    }
  }
};

/// Which pieces to halve (see halved()): those with errors above `bound`, but none so short that coordinates
/// do not tell its ends apart: the curve jumps there. Empty where there is none. Rough halves get the cells
/// of the whole, so that cells become small about the place where a curve bends sharply, and only there.
std::vector<bool> halve_rough(std::vector<int>& cells, const HalfErrors& errors,
                              std::span<const Piece> pieces, double bound);

}  // namespace sweepkit::sweep
