// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

// The rate against a difference over 2e-6: its own error is about the third derivative's share of 1e-12 and
// rounding over 1e-6.
void expect_rates(const Law& law, double from, double to) {
  constexpr double kStep = 1e-6;
  for (int i = 1; i < 211; ++i) {  // 211 is prime: no sample lies on a point, where the slope bends
    const double t = from + (to - from) * i / 211.0;
    const double difference = (law.at(t + kStep).value - law.at(t - kStep).value) / (2 * kStep);
    EXPECT_NEAR(law.at(t).rate, difference, 1e-5 * (1 + std::abs(difference))) << t;
  }
}

TEST(Law, OfANumberIsThatNumberEverywhere) {
  const Law law = 2.5;
  EXPECT_TRUE(law.is_constant());
  for (const double t : {0.0, 0.3, 1.0}) {
    EXPECT_EQ(law.at(t).value, 2.5);
    EXPECT_EQ(law.at(t).rate, 0);
  }
}

TEST(Law, OfTwoPointsIsALine) {
  const Law law = Law::through({{0.25, 1}, {0.75, 3}});
  EXPECT_EQ(law.at(0.5).value, 2);
  EXPECT_EQ(law.at(0.5).rate, 4);
  EXPECT_EQ(law.at(0.1).value, 1) << "before the first point its value is kept";
  EXPECT_EQ(law.at(0.1).rate, 0);
  EXPECT_EQ(law.at(0.9).value, 3);
}

TEST(Law, GoesThroughItsPointsToTheBitWithoutOvershoot) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 200; ++round) {
    std::vector<glm::dvec2> points;
    double t = 0;
    while (points.size() < 12) {
      points.push_back({t, 4 * unit(random) - 2});
      t += unit(random) < 0.5 ? 1e-4 : 0.1 * unit(random) + 1e-6;  // uneven spacing
      if (t > 1) break;
    }
    if (points.size() < 2) continue;
    const Law law = Law::through(points);
    for (const glm::dvec2& p : points) EXPECT_EQ(law.at(p.x).value, p.y);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto [low, high] = std::minmax(points[i - 1].y, points[i].y);
      for (int k = 1; k < 40; ++k) {
        const double at = points[i - 1].x + (points[i].x - points[i - 1].x) * k / 40.0;
        // Rounding of values up to 2.
        EXPECT_GE(law.at(at).value, low - 1e-15);
        EXPECT_LE(law.at(at).value, high + 1e-15);
      }
    }
  }
}

TEST(Law, ThroughPointsHasTheRateOfItsOwnSlope) {
  expect_rates(Law::through({{0, 1}, {0.2, 1.5}, {0.5, 1.5}, {0.6, 0.2}, {1, 0}}), 0, 1);
}

TEST(Law, OfABezierCurveFollowsIt) {
  // t = s^2, value = 2 s (1 - s) + 3 s^2 = 2 s + s^2.
  const Law law = Law::bezier({{0, 0}, {0, 1}, {1, 3}});
  for (int i = 0; i <= 50; ++i) {
    const double s = i / 50.0;
    EXPECT_NEAR(law.at(s * s).value, 2 * s + s * s, 4e-16 + 4e-15 * s);
    if (i == 0) continue;
    EXPECT_NEAR(law.at(s * s).rate, (2 + 2 * s) / (2 * s), 1e-12 / (s * s));
  }
  EXPECT_GT(law.at(0).rate, 1e6) << "it stands upright there";
  EXPECT_TRUE(std::isfinite(law.at(0).rate));
  expect_rates(Law::bezier({{0, 1}, {0.6, 4}, {0.6, -2}, {1, 0.5}}), 0, 1);
}

TEST(Law, OfABezierCurveThatRestsStaysFinite) {
  const Law law = Law::bezier({{0, 0}, {0, 0}, {0, 0}, {1, 1}, {1, 1}});
  for (int i = 0; i <= 1000; ++i) {
    const Law::Value at = law.at(i / 1000.0);
    EXPECT_TRUE(std::isfinite(at.value) && std::isfinite(at.rate)) << i;
    EXPECT_NEAR(at.value, i / 1000.0, 1e-12) << "value and t have the same control points";
  }
}

TEST(Law, RefusesWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Law{nan}, InputError);
  EXPECT_THROW(Law::through({}), InputError);
  EXPECT_THROW(Law::through({{0, 1}, {0, 2}}), InputError);
  EXPECT_THROW(Law::through({{0.5, 1}, {0.2, 2}}), InputError);
  EXPECT_THROW(Law::through({{0, 1}, {1.5, 2}}), InputError);
  EXPECT_THROW(Law::through({{-0.1, 1}, {1, 2}}), InputError);
  EXPECT_THROW(Law::through({{0, nan}, {1, 2}}), InputError);
  EXPECT_THROW(Law::through({{nan, 0}, {1, 2}}), InputError);
  EXPECT_THROW(Law::bezier({{0.5, 1}, {0.5, 2}}), InputError);
  EXPECT_THROW(Law::bezier({{0.5, 1}}), InputError);
}

}  // namespace
}  // namespace sweepkit::sweep
