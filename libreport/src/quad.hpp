// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <quadmath.h>

#include <cmath>

namespace sweepkit::report {

/// 113 bits: what doubles are measured against.
__extension__ using Quad = __float128;

inline Quad square_root(Quad x) {
  return sqrtq(x);
}
inline double square_root(double x) {
  return std::sqrt(x);
}
inline Quad cosine(Quad x) {
  return cosq(x);
}
inline double cosine(double x) {
  return std::cos(x);
}
inline Quad sine(Quad x) {
  return sinq(x);
}
inline double sine(double x) {
  return std::sin(x);
}
inline Quad magnitude(Quad x) {
  return fabsq(x);
}

inline Quad quad_pi() {
  static const Quad pi = acosq(-1);
  return pi;
}

/// Gauss-Legendre rule of 20 points in quadruple precision: exact for polynomials to degree 39. Its nodes are
/// found at the first call, by Newton's method on the Legendre polynomial.
struct QuadRule {
  static constexpr int kPoints = 20;
  Quad nodes[kPoints];  ///< on [-1, 1]
  Quad weights[kPoints];
};
const QuadRule& quad_rule();

template <class Function>
Quad integrate(Quad from, Quad to, int panels, Function&& function) {
  const QuadRule& rule = quad_rule();
  const Quad half = (to - from) / (2 * panels);
  Quad sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    const Quad middle = from + (2 * panel + 1) * half;
    for (int i = 0; i < QuadRule::kPoints; ++i)
      sum += rule.weights[i] * function(middle + half * rule.nodes[i]);
  }
  return half * sum;
}

}  // namespace sweepkit::report
