// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "quad.hpp"

namespace sweepkit::report {
namespace {

// P(n) and its derivative at x, by Bonnet's recursion.
struct Legendre {
  Quad value;
  Quad slope;
};

Legendre legendre(int n, Quad x) {
  Quad before = 1;
  Quad value = x;
  for (int k = 2; k <= n; ++k) {
    const Quad next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, n * (x * value - before) / (x * x - 1)};
}

QuadRule make_rule() {
  QuadRule rule;
  constexpr int n = QuadRule::kPoints;
  for (int i = 0; i < n; ++i) {
    Quad x = cosq(quad_pi() * (static_cast<Quad>(i) + 0.75) / (n + 0.5));
    // Quadratic from four digits on: six steps are past 113 bits.
    for (int step = 0; step < 6; ++step) {
      const Legendre at = legendre(n, x);
      x -= at.value / at.slope;
    }
    const Quad slope = legendre(n, x).slope;
    rule.nodes[i] = x;
    rule.weights[i] = 2 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace

const QuadRule& quad_rule() {
  static const QuadRule rule = make_rule();
  return rule;
}

}  // namespace sweepkit::report
