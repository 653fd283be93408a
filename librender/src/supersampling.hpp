// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace sweepkit::render {

/// Shrinks n x n pixels of a larger picture (colour and coverage) to one, row by row as they come: 3 x 3 with
/// the paper's weights (3.2.2: 1/4 in the middle, 1/8 at the sides, 1/16 at the corners), any other n with
/// equal ones.
class Shrinker {
 public:
  Shrinker(int n, int width);

  /// Row `k` (0 to n - 1) of the n that make one; `large` has n * width pixels.
  void add(int k, const std::vector<glm::dvec4>& large);
  /// The finished row, the first `channels` of each pixel; starts the next one.
  void take(float* out, int channels);
  std::size_t bytes() const { return sums_.size() * sizeof(sums_[0]); }

 private:
  int n_;
  std::vector<double> weights_;  // along one axis; the product of two is a pixel's
  std::vector<glm::dvec4> sums_;
};

}  // namespace sweepkit::render
