// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/primitives.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

constexpr double kPi = std::numbers::pi;
// Promised of arc length.
constexpr double kLength = 1e-9;

// A closed smooth curve's length is the mean speed over evenly spaced parameters, exact to rounding once they
// are many [Trefethen and Weideman 2014].
template <class Speed>
double mean_over_period(Speed&& speed) {
  constexpr int kSamples = 1 << 14;
  long double sum = 0;
  for (int i = 0; i < kSamples; ++i) sum += speed(2 * kPi * i / kSamples);
  return static_cast<double>(sum / kSamples);
}

TEST(Primitives, BeginOnTheXAxisAndClose) {
  for (const Curve2& curve : {circle_contour(2), ellipse_contour(2, 1), rectangle_contour(4, 3),
                              rectangle_contour(4, 3, 1), polygon_contour(7, 2), star_contour(5, 2, 1)}) {
    EXPECT_TRUE(curve.is_closed());
    EXPECT_EQ(curve.evaluate({0, 0}).position, glm::dvec2(2, 0));
    EXPECT_GT(curve.evaluate(curve.locate(0.01)).position.y, 0) << "counter-clockwise";
  }
}

TEST(Primitives, HaveTheLengthsOfTheirFormulas) {
  EXPECT_NEAR(circle_contour(3).length(), 6 * kPi, 6 * kPi * kLength);
  EXPECT_NEAR(rectangle_contour(4, 3).length(), 14, 14 * kLength);
  EXPECT_NEAR(rectangle_contour(4, 3, 0.5).length(), 10 + kPi, 13 * kLength);
  EXPECT_NEAR(rectangle_contour(4, 3, 1.5).length(), 2 + 3 * kPi, 11 * kLength) << "two half circles";
  EXPECT_NEAR(polygon_contour(6, 2).length(), 12, 12 * kLength);
  EXPECT_NEAR(star_contour(4, 2, 1).length(), 8 * std::sqrt(5 - 2 * std::sqrt(2)), 12 * kLength);
  EXPECT_NEAR(arc_contour(2, 30, -60).length(), kPi, kPi * kLength);
  EXPECT_NEAR(helix(2, 3, 5.5).length(), 5.5 * std::hypot(4 * kPi, 3), 80 * kLength);
  for (const double flat : {1.0, 0.5, 0.01, 1e-4}) {
    // The arithmetic-geometric mean's series for an ellipse's length [Gauss].
    double a = 1;
    double g = flat;
    double sum = 1 - (1 - flat * flat) / 2;
    for (double power = 1; std::abs(a - g) > 1e-15; power *= 2) {
      const double next = (a + g) / 2;
      g = std::sqrt(a * g);
      sum -= power * (a - next) * (a - next);
      a = next;
    }
    const double expected = 2 * kPi * sum / a;
    EXPECT_NEAR(ellipse_contour(1, flat).length(), expected, expected * kLength) << flat;
  }
}

TEST(Primitives, TheTorusKnotIsTheFormulasOwn) {
  const Curve3 knot = torus_knot(2, 3, 2, 0.7);
  EXPECT_TRUE(knot.is_closed());
  for (int i = 0; i <= 100; ++i) {
    const double s = 2 * kPi * i / 100;
    const double w = 2 + 0.7 * std::cos(3 * s);
    const glm::dvec3 expected(w * std::cos(2 * s), 0.7 * std::sin(3 * s), -w * std::sin(2 * s));
    EXPECT_LT(glm::length(knot.evaluate({0, i / 100.0}).position - expected), 1e-14);
  }
  const double expected = 2 * kPi * mean_over_period([](double s) {
                            const double w = 2 + 0.7 * std::cos(3 * s);
                            return std::sqrt(4 * w * w + 9 * 0.49);
                          });
  EXPECT_NEAR(knot.length(), expected, expected * kLength);
}

// Differences of second order over 2e-4: 1e-8 of the next derivative but one, which is below 1e6 here.
template <int D>
void expect_derivatives(const Curve<D>& curve) {
  constexpr double kStep = 1e-4;
  const double scale = curve.length();
  for (int i = 1; i < 20; ++i) {
    const double t = i / 20.0;
    const CurvePoint<D> before = curve.evaluate({0, t - kStep});
    const CurvePoint<D> here = curve.evaluate({0, t});
    const CurvePoint<D> after = curve.evaluate({0, t + kStep});
    const double tolerance = 1e-8 * std::pow(60, 3) * scale;
    EXPECT_LT(glm::length((after.position - before.position) / (2 * kStep) - here.first), tolerance);
    EXPECT_LT(glm::length((after.first - before.first) / (2 * kStep) - here.second), 60 * tolerance);
    EXPECT_LT(glm::length((after.second - before.second) / (2 * kStep) - here.third), 3600 * tolerance);
  }
}

TEST(Primitives, HaveTheDerivativesOfTheirPoints) {
  expect_derivatives(torus_knot(2, 3, 2, 0.7));
  expect_derivatives(helix(1, 0.5, 3));
  expect_derivatives(arc_contour(1, 0, 200));
  expect_derivatives(bezier_curve<3>({{0, 0, 0}, {1, 2, 0}, {3, -1, 2}, {4, 1, 1}, {2, 2, 2}}));
}

TEST(Primitives, LaidFlatTheyRunCounterClockwiseSeenFromAbove) {
  for (const Curve3& curve : {circle_trajectory(2), laid_flat(rectangle_contour(4, 2, 0.5))}) {
    EXPECT_EQ(curve.evaluate({0, 0}).position, glm::dvec3(2, 0, 0));
    const glm::dvec3 later = curve.evaluate(curve.locate(0.1)).position;
    EXPECT_EQ(later.y, 0);
    EXPECT_LT(later.z, 0);
  }
}

TEST(Primitives, AHelixRisesByItsPitchATurn) {
  const Curve3 up = helix(1, 0.25, 4);
  EXPECT_LT(glm::length(up.evaluate({0, 1}).position - glm::dvec3(1, 1, 0)), 1e-14);
  EXPECT_FALSE(up.is_closed());
  EXPECT_LT(helix(1, -0.25, 4).evaluate({0, 1}).position.y, 0);
}

TEST(Primitives, RefuseWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(circle_contour(0), InputError);
  EXPECT_THROW(circle_contour(nan), InputError);
  EXPECT_THROW(ellipse_contour(1, -1), InputError);
  EXPECT_THROW(rectangle_contour(1, 2, 0.6), InputError);
  EXPECT_THROW(rectangle_contour(1, 2, -0.1), InputError);
  EXPECT_THROW(polygon_contour(2, 1), InputError);
  EXPECT_THROW(star_contour(1, 1, 1), InputError);
  EXPECT_THROW(arc_contour(1, 10, 10), InputError);
  EXPECT_THROW(arc_contour(1, 0, 361), InputError);
  EXPECT_THROW(helix(1, nan, 1), InputError);
  EXPECT_THROW(helix(1, 1, 0), InputError);
  EXPECT_THROW(torus_knot(2, 4, 2, 1), InputError);
  EXPECT_THROW(torus_knot(2, 3, 1, 1), InputError);
}

}  // namespace
}  // namespace sweepkit::sweep
