// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "cuts.hpp"

#include <algorithm>
#include <numeric>

namespace sweepkit::sweep {
namespace {

std::vector<std::size_t> cut_greedily(std::size_t first, std::size_t last, const ChordError& error,
                                      double bound) {
  std::vector<std::size_t> cuts = {first};
  std::size_t stride = 1;  // the last cell's is a good guess for the next
  while (cuts.back() < last) {
    const std::size_t from = cuts.back();
    const auto fits = [&](std::size_t to) { return to == from + 1 || error(from, to) <= bound; };
    // The farthest end that fits lies in [low, high).
    std::size_t low = from + 1;
    std::size_t high = last + 1;
    for (std::size_t step = stride; from + step <= last; step *= 2) {
      if (!fits(from + step)) {
        high = from + step;
        break;
      }
      low = from + step;
    }
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (fits(middle) ? low : high) = middle;
    }
    stride = low - from;
    cuts.push_back(low);
  }
  return cuts;
}

}  // namespace

std::vector<std::size_t> cut(std::size_t first, std::size_t last, std::size_t least, const ChordError& error,
                             double bound) {
  std::vector<std::size_t> cuts = cut_greedily(first, last, error, bound);
  if (cuts.size() == 2) {
    const std::size_t cells = std::min(least, last - first);
    cuts.resize(cells + 1);
    for (std::size_t i = 0; i <= cells; ++i) cuts[i] = first + (last - first) * i / cells;
  }
  while (cuts.size() - 1 < std::min(least, last - first)) {
    // The cuts there are stay: they may stand where the curve bends sharply.
    std::vector<std::size_t> widths(cuts.size());
    std::adjacent_difference(cuts.begin(), cuts.end(), widths.begin());
    const auto widest = std::max_element(widths.begin() + 1, widths.end()) - widths.begin();
    cuts.insert(cuts.begin() + widest, cuts[widest - 1] + (cuts[widest] - cuts[widest - 1]) / 2);
  }
  return cuts;
}

}  // namespace sweepkit::sweep
