// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace sweepkit::sweep {

/// Gauss-Legendre rule of 16 points: exact for polynomials to degree 31.
template <class Function>
double gauss_legendre_16(double from, double to, Function&& function) {
  static constexpr std::array<double, 8> kNodes = {0.0950125098376374401853193, 0.2816035507792589132304605,
                                                   0.4580167776572273863424194, 0.6178762444026437484466718,
                                                   0.7554044083550030338951012, 0.8656312023878317438804679,
                                                   0.9445750230732325760779884, 0.9894009349916499325961542};
  static constexpr std::array<double, 8> kWeights = {
      0.1894506104550684962853967, 0.1826034150449235888667637, 0.1691565193950025381893121,
      0.1495959888165767320815017, 0.1246289712555338720524763, 0.0951585116824927848099251,
      0.0622535239386478928628438, 0.0271524594117540948517806};
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  double sum = 0;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    sum += kWeights[i] * (function(middle - half * kNodes[i]) + function(middle + half * kNodes[i]));
  }
  return half * sum;
}

}  // namespace sweepkit::sweep
