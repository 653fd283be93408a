// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "supersampling.hpp"

namespace sweepkit::render {

Shrinker::Shrinker(int n, int width) : n_(n), sums_(static_cast<std::size_t>(width), glm::dvec4(0.0)) {
  // The paper's weights are the product of (1/4, 1/2, 1/4) with itself.
  weights_ = n == 3 ? std::vector<double>{0.25, 0.5, 0.25}
                    : std::vector<double>(static_cast<std::size_t>(n), 1.0 / n);
}

void Shrinker::add(int k, const std::vector<glm::dvec4>& large) {
  for (std::size_t x = 0; x < sums_.size(); ++x) {
    glm::dvec4 row(0.0);
    for (std::size_t i = 0; i < weights_.size(); ++i)
      row += weights_[i] * large[x * static_cast<std::size_t>(n_) + i];
    sums_[x] += weights_[static_cast<std::size_t>(k)] * row;
  }
}

void Shrinker::take(float* out, int channels) {
  for (glm::dvec4& sum : sums_) {
    for (glm::length_t k = 0; k < channels; ++k) *out++ = static_cast<float>(sum[k]);
    sum = glm::dvec4(0.0);
  }
}

}  // namespace sweepkit::render
