// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace sweepkit::report {

/// `order` boxes of `width` texels convolved: whole numbers whose sum is width^order, for
/// order * (width - 1) + 1 texels.
inline std::vector<double> box_weights(int order, int width) {
  std::vector<double> weights{1};
  for (int n = 0; n < order; ++n) {
    std::vector<double> next(weights.size() + static_cast<std::size_t>(width) - 1, 0.0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      for (std::size_t k = 0; k < static_cast<std::size_t>(width); ++k) next[i + k] += weights[i];
    }
    weights = std::move(next);
  }
  return weights;
}

}  // namespace sweepkit::report
