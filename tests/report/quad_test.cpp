// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "quad.hpp"

#include <gtest/gtest.h>

namespace sweepkit::report {
namespace {

// 113 bits: a few units of 2^-112 for sums of twenty terms.
constexpr double kFewUnits = 1e-32;

TEST(QuadRule, IsExactForPolynomialsUpToDegree39) {
  for (int degree = 0; degree <= 39; ++degree) {
    const Quad sum = integrate(0, 1, 1, [&](Quad x) { return powq(x, degree); });
    EXPECT_LE(static_cast<double>(magnitude(sum - static_cast<Quad>(1) / (degree + 1))), kFewUnits) << degree;
  }
}

TEST(QuadRule, IntegratesASineOverPanels) {
  const Quad sum = integrate(0, quad_pi(), 8, [](Quad x) { return sine(x); });
  EXPECT_LE(static_cast<double>(magnitude(sum - 2)), kFewUnits);
}

}  // namespace
}  // namespace sweepkit::report
