// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace sweepkit::report {

/// order! width^order times the weights of texels under `order` boxes of `width` convolved, from the first
/// one on: whole numbers. A box is `width` boxes of one texel side by side, and `order` of those convolved
/// are a B-spline whose share in each texel is Euler's: 1; 1, 1; 1, 4, 1.
inline std::vector<double> box_weights(int order, int width) {
  static const std::vector<double> kEuler[] = {{1}, {1, 1}, {1, 4, 1}};
  std::vector<double> weights = kEuler[order - 1];
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
