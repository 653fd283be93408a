// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "frame_methods.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test_curves.hpp"

namespace sweepkit::report {
namespace {

TEST(TestCurves, ExactNormalsAreUnitPerpendicularAndTurnAboutTheTangentNotAtAll) {
  for (const TestCurve& curve : test_curves()) {
    constexpr int kSteps = 4096;
    const std::vector<glm::dvec3> normals = curve.normals(kSteps);
    ASSERT_EQ(normals.size(), kSteps + 1u);
    const double step = (curve.to - curve.from) / kSteps;
    for (int i = 0; i <= kSteps; i += 64) {
      const sweep::CurvePoint<3> point = curve.evaluate(curve.from + step * i);
      const glm::dvec3 tangent = glm::normalize(point.first);
      const glm::dvec3& r = normals[static_cast<std::size_t>(i)];
      EXPECT_NEAR(glm::length(r), 1, 1e-15);
      // The tangent is in double: K's angle 7u, up to 44, is rounded by 3.6e-15.
      EXPECT_NEAR(glm::dot(r, tangent), 0, 1e-14) << curve.name;
      if (i == 0 || i == kSteps) continue;
      // r' has no part along T x r; the central difference errs by step^2 / 6 of the third derivative, which
      // these curves keep below 1e4.
      const glm::dvec3 slope =
          (normals[static_cast<std::size_t>(i) + 1] - normals[static_cast<std::size_t>(i) - 1]) / (2 * step);
      EXPECT_NEAR(glm::dot(slope, glm::cross(tangent, r)), 0, 1e4 * step * step) << curve.name;
    }
  }
}

}  // namespace
}  // namespace sweepkit::report
