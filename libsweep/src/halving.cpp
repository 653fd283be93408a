// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "halving.hpp"

namespace sweepkit::sweep {
namespace {

// A piece that is so short a share of the whole is a point: ends of segments that are as near as this meet.
constexpr double kShortestShare = 1e-9;

}  // namespace

std::vector<bool> halve_rough(std::vector<int>& cells, const HalfErrors& errors,
                              std::span<const Piece> pieces, double bound) {
  double length = 0;
  for (const Piece& piece : pieces) length += piece.length;
  std::vector<bool> is_halved(cells.size(), false);
  bool is_any_halved = false;
  std::vector<int> refined;
  refined.reserve(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_left_rough = errors.left[i] > bound;
    const bool is_right_rough = errors.right[i] > bound;
    if ((!is_left_rough && !is_right_rough) || pieces[i].length < kShortestShare * length) {
      refined.push_back(cells[i]);
      continue;
    }
    is_halved[i] = is_any_halved = true;
    const int half = std::max(2, (cells[i] + 1) / 2);
    refined.push_back(is_left_rough ? cells[i] : half);
    refined.push_back(is_right_rough ? cells[i] : half);
  }
  cells = std::move(refined);
  return is_any_halved ? is_halved : std::vector<bool>();
}

}  // namespace sweepkit::sweep
