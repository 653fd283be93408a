// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "bezier_methods.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sweepkit::report {
namespace {

std::vector<glm::dvec3> evaluate(const BezierMethod& method, const std::vector<glm::dvec3>& control,
                                 const std::vector<double>& t) {
  std::vector<glm::dvec3> points(t.size());
  method.evaluate(control, t, points);
  return points;
}

TEST(BezierMethods, AgreeWithAParabolaWrittenOut) {
  // x = 2t, y = t^2, z = 1 - 3t + 5t^2, all exact in binary at these t.
  const std::vector<glm::dvec3> control = {{0, 0, 1}, {1, 0, -0.5}, {2, 1, 3}};
  const std::vector<double> t = {0, 0.125, 0.25, 0.5, 0.75, 1};
  for (const BezierMethod& method : bezier_methods()) {
    const std::vector<glm::dvec3> points = evaluate(method, control, t);
    for (std::size_t i = 0; i < t.size(); ++i) {
      const glm::dvec3 right(2 * t[i], t[i] * t[i], 1 - 3 * t[i] + 5 * t[i] * t[i]);
      EXPECT_LE(glm::distance(points[i], right), 4e-16) << method.name << " at " << t[i];
    }
  }
}

TEST(BezierMethods, CompensatedIsExactToRoundingWhereOthersLoseHalfTheirDigits) {
  // (t - 3/4)^8 at 0.7 has the condition number (0.4 / 0.05)^8 = 1.7e7.
  std::vector<glm::dvec3> control;
  for (int i = 0; i <= 8; ++i) control.emplace_back(std::pow(-0.75, 8 - i) * std::pow(0.25, i));
  const double t = 0.6875;  // 3/4 - 1/16: the value is 2^-32
  for (const BezierMethod& method : bezier_methods()) {
    const double error = std::abs(evaluate(method, control, {t})[0].x * 0x1p32 - 1);
    if (method.name == "compensated de Casteljau") {
      EXPECT_LE(error, 0x1p-52);
    } else {
      EXPECT_LE(error, 1e-7) << method.name;
    }
  }
}

}  // namespace
}  // namespace sweepkit::report
