// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"

namespace sweepkit::sweep {
namespace {

constexpr double kPi = std::numbers::pi;

template <class Make>
std::string message_of(Make&& make) {
  try {
    make();
  } catch (const InputError& error) {
    return error.problem();
  }
  return "no error";
}

TEST(Curve, MeasuresACircleToTwelveDigits) {
  EXPECT_NEAR(circle_contour(3).length(), 6 * kPi, 1e-12 * 6 * kPi);
}

TEST(Curve, MeasuresAParabolaAsItsClosedFormDoes) {
  // y = x^2 over [0, 1] is the quadratic Bezier (0,0), (1/2,0), (1,1).
  const double exact = 0.5 * std::sqrt(5.0) + 0.25 * std::asinh(2.0);
  EXPECT_NEAR(bezier_curve<2>({{0, 0}, {0.5, 0}, {1, 1}}).length(), exact, 1e-12 * exact);
}

TEST(Curve, MeasuresACuspToNineDigits) {
  // The semicubical parabola (t^2, t^3), t in [-1, 1], as a cubic: its speed |t| sqrt(4 + 9 t^2) has a kink
  // at the cusp.
  const Curve2 cusp = bezier_curve<2>({{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}});
  const double exact = 2.0 / 27 * (13 * std::sqrt(13.0) - 8);
  EXPECT_NEAR(cusp.length(), exact, 1e-9 * exact);
}

TEST(Curve, LocatesEqualStepsOfArcLength) {
  const Curve2 curve = bezier_curve<2>({{0, 0}, {5, 0.1}, {-3, 2}, {1, 1}});
  const double length = curve.length();
  for (int i = 0; i <= 20; ++i) {
    const double wanted = length * i / 20;
    const CurveLocation at = curve.locate(wanted);
    // A fine polyline up to the location, far coarser than the promise: 1e-6 only tells that the right place
    // was found.
    double travelled = 0;
    glm::dvec2 before = curve.evaluate({0, 0}).position;
    for (int k = 1; k <= 4000; ++k) {
      const glm::dvec2 here = curve.evaluate({0, at.t * k / 4000}).position;
      travelled += glm::length(here - before);
      before = here;
    }
    EXPECT_NEAR(travelled, wanted, 1e-6 * length);
  }
}

TEST(Curve, EvaluatesDegree64AsQuadruplePrecisionDoes) {
  std::vector<glm::dvec2> control;
  for (int i = 0; i <= 64; ++i) control.push_back({i / 64.0, (i % 2 == 0 ? 1 : -1) * (i % 7)});
  const Segment<2> segment = BezierSegment<2>{control};
  for (const double t : {0.0, 0.013, 0.37, 0.5, 0.99, 1.0}) {
    __extension__ using Quad = __float128;
    std::vector<Quad> level;
    for (const glm::dvec2& p : control) level.push_back(p.y);
    for (std::size_t left = 64; left > 0; --left) {
      for (std::size_t i = 0; i < left; ++i) level[i] = (1 - Quad(t)) * level[i] + Quad(t) * level[i + 1];
    }
    // Convex combinations of values up to 6: 3 n units in the last place bound the error (n = 64).
    EXPECT_NEAR(evaluate<2>(segment, t).position.y, static_cast<double>(level[0]), 3 * 64 * 6 * 1.2e-16);
  }
}

TEST(Curve, DerivativesAgreeWithFiniteDifferences) {
  const Segment<3> bezier = BezierSegment<3>{{{0, 0, 0}, {1, 2, 0}, {3, -1, 2}, {4, 1, 1}, {2, 2, 2}}};
  const Segment<3> arc = ArcSegment<3>{{1, 2, 3}, {2, 0, 0}, {0, 0, -1}, 10, 200};
  for (const Segment<3>& segment : {bezier, arc}) {
    for (const double t : {0.1, 0.5, 0.8}) {
      const double h =
          1e-4;  // central differences: error of order h^2 = 1e-8 times the third derivatives (under 1e3)
      const CurvePoint<3> at = evaluate<3>(segment, t);
      const auto before = evaluate<3>(segment, t - h);
      const auto after = evaluate<3>(segment, t + h);
      EXPECT_LT(glm::length((after.position - before.position) / (2 * h) - at.first), 1e-5);
      EXPECT_LT(glm::length((after.first - before.first) / (2 * h) - at.second), 1e-5);
    }
  }
}

TEST(Curve, CircleEndsWhereItBeganToTheBit) {
  const Curve2 circle = circle_contour(0.1);
  EXPECT_TRUE(circle.is_closed());
  EXPECT_EQ(circle.evaluate({0, 0}).position, circle.evaluate({0, 1}).position);
}

TEST(Curve, CircleTrajectoryRunsCounterClockwiseSeenFromAbove) {
  const Curve3 circle = circle_trajectory(2);
  EXPECT_EQ(circle.evaluate({0, 0}).position, glm::dvec3(2, 0, 0));
  EXPECT_EQ(circle.evaluate({0, 0.25}).position, glm::dvec3(0, 0, -2));
}

TEST(Curve, KnowsCornersFromSmoothJoints) {
  const Curve2 smooth = joined_bezier_curve<2>({{{0, 0}, {1, 0}}, {{1, 0}, {2, 0}, {2, 1}}});
  EXPECT_FALSE(smooth.is_corner(1));
  const Curve2 square = polyline<2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(square.is_corner(i));
}

TEST(Curve, ClosesWhereTheEndsCoincide) {
  EXPECT_TRUE(polyline<2>({{0, 0}, {1, 0}, {1, 1}, {0, 0}}, false).is_closed());
  EXPECT_FALSE(polyline<2>({{0, 0}, {1, 0}, {1, 1}}, false).is_closed());
}

TEST(Curve, LeavesOutSegmentsWithoutLength) {
  const Curve2 curve = polyline<2>({{0, 0}, {1, 0}, {1, 0}, {1, 0}, {2, 0}}, false);
  EXPECT_EQ(curve.segments().size(), 2u);
  EXPECT_DOUBLE_EQ(curve.length(), 2);
}

TEST(Curve, TangentIsFiniteWhereControlPointsCoincide) {
  const Curve3 curve = bezier_curve<3>({{0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {1, 1, 0}});
  const glm::dvec3 diagonal = glm::normalize(glm::dvec3(1, 1, 0));
  // The second derivative stands in for the first there: exact but for its rounding.
  for (const double t : {0.0, 1e-12, 0.5, 1 - 1e-12, 1.0})
    EXPECT_LT(glm::length(curve.tangent({0, t}) - diagonal), 1e-14) << t;
  // The second derivative is 0 as well: a short chord stands in.
  const Curve3 flat = bezier_curve<3>({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}});
  for (const double t : {0.0, 1.0}) EXPECT_LT(glm::length(flat.tangent({0, t}) - diagonal), 1e-9) << t;
}

TEST(Curve, TangentWherePointsAreRepeatedIsTowardsTheFirstThatIsNot) {
  for (const std::size_t count : {2, 3, 30}) {
    std::vector<glm::dvec2> control(count, {0.5, 0.25});
    control.insert(control.end(), {{1.5, 2.25}, {4, -1}});
    const glm::dvec2 exact = glm::normalize(glm::dvec2(1, 2));
    // Exact differences, a length and a quotient.
    EXPECT_LT(glm::distance(tangent<2>(BezierSegment<2>{control}, 0), exact), 5e-16) << count;
    std::reverse(control.begin(), control.end());
    EXPECT_LT(glm::distance(tangent<2>(BezierSegment<2>{control}, 1), -exact), 5e-16) << count;
  }
}

TEST(Curve, TangentAtACuspIsTheLimitFromEitherSide) {
  // (t^2, t^3) cut at its cusp: it arrives along -x and leaves along +x.
  const Curve2 cusp = joined_bezier_curve<2>(
      {{{1, -1}, {1.0 / 3, 0}, {0, 0}, {0, 0}}, {{0, 0}, {0, 0}, {1.0 / 3, 0}, {1, 1}}});
  EXPECT_LT(glm::length(cusp.tangent({0, 1}) - glm::dvec2(-1, 0)), 1e-14);
  EXPECT_LT(glm::length(cusp.tangent({1, 0}) - glm::dvec2(1, 0)), 1e-14);
  EXPECT_TRUE(cusp.is_corner(1));
}

TEST(FreeCurve, PassesThroughItsPoints) {
  const std::vector<glm::dvec3> points = {{0, 0, 0}, {1, 0, 0}, {1.001, 5, 0}, {-3, 5, 2}};
  for (const bool is_closed : {false, true}) {
    const Curve3 curve = free_curve<3>(points, is_closed);
    EXPECT_EQ(curve.is_closed(), is_closed);
    ASSERT_EQ(curve.segments().size(), is_closed ? 4u : 3u);
    for (std::size_t i = 0; i < curve.segments().size(); ++i) {
      EXPECT_EQ(curve.evaluate({i, 0}).position, points[i]);
      EXPECT_EQ(curve.evaluate({i, 1}).position, points[(i + 1) % 4]);
      EXPECT_FALSE(curve.is_corner(i)) << i;
    }
  }
}

TEST(FreeCurve, HasNoLoopBesideAShortSpan) {
  // A Catmull-Rom spline with even knots turns by more than half a turn inside the short span here: it makes
  // a loop.
  const Curve2 curve = free_curve<2>({{0, 0}, {10, 0}, {10.1, 1}, {20, 1}}, false);
  for (std::size_t segment = 0; segment < 3; ++segment) {
    double turning = 0;
    for (int k = 0; k < 200; ++k) {
      const glm::dvec2 a = curve.tangent({segment, k / 200.0});
      const glm::dvec2 b = curve.tangent({segment, (k + 1) / 200.0});
      turning += std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
    }
    EXPECT_LT(turning, kPi) << segment;
  }
}

// The distance of p from the line segment a b.
double distance_from(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const double s = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::length(p - (a + s * along));
}

TEST(FreeCurve, StaysNearItsPolygonHoweverUnevenItsPoints) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> turn(-kPi, kPi);
  std::uniform_real_distribution<double> digits(-9, 0);
  for (int round = 0; round < 400; ++round) {
    std::vector<glm::dvec2> points = {{0, 0}};
    std::vector<double> chords;
    for (int i = 0; i < 9; ++i) {
      const double angle = turn(random);
      points.push_back(points.back() +
                       std::pow(10, digits(random)) * glm::dvec2(std::cos(angle), std::sin(angle)));
      chords.push_back(glm::length(points[i + 1] - points[i]));
    }
    const Curve2 curve = free_curve<2>(points, false);
    ASSERT_EQ(curve.segments().size(), chords.size());
    for (std::size_t i = 0; i < chords.size(); ++i) {
      const double before = i == 0 ? chords[i] : chords[i - 1];
      const double after = i + 1 == chords.size() ? chords[i] : chords[i + 1];
      const double handle = std::min(2.0 / 3 * chords[i], std::max(before, after));
      double farthest = 0;
      for (int k = 0; k <= 200; ++k) {
        farthest = std::max(farthest,
                            distance_from(curve.evaluate({i, k / 200.0}).position, points[i], points[i + 1]));
      }
      // 9e-15: rounding of points as far as 9 from the origin.
      EXPECT_LE(farthest, 0.75 * handle + 9e-15) << "round " << round << " span " << i;
      if (i > 0) {
        const double bend = glm::length(curve.tangent({i, 0}) - curve.tangent({i - 1, 1}));
        // The short chord's direction is known to 1e-15 / 1e-9.
        EXPECT_LT(bend, 1e-5) << "round " << round << " point " << i;
      }
    }
  }
}

TEST(FreeCurve, NeverTurnsBackBetweenPointsOnALine) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> digits(-9, 0);
  for (int round = 0; round < 200; ++round) {
    std::vector<glm::dvec2> points = {{0, 0}};
    for (int i = 0; i < 9; ++i) points.push_back(points.back() + glm::dvec2(std::pow(10, digits(random)), 0));
    const Curve2 curve = free_curve<2>(points, false);
    for (std::size_t i = 0; i < curve.segments().size(); ++i) {
      for (int k = 0; k <= 50; ++k) EXPECT_GE(curve.evaluate({i, k / 50.0}).first.x, 0) << round << " " << i;
    }
  }
}

TEST(FreeCurve, KeepsThePublishedSplineWhereSpacingIsNearlyEven) {
  // [Yuksel11]: the same point by the recursive formula of Barry and Goldman with knots at sqrt(chord).
  const std::vector<glm::dvec2> p = {{0, 0}, {1, 2}, {4, 2.5}, {4.5, 0.5}};
  std::array<double, 4> knot{};
  for (int i = 1; i < 4; ++i) knot[i] = knot[i - 1] + std::sqrt(glm::length(p[i] - p[i - 1]));
  const Curve2 curve = free_curve<2>(p, false);
  for (const double share : {0.1, 0.5, 0.8}) {
    const double t = knot[1] + share * (knot[2] - knot[1]);
    const auto mix = [&](glm::dvec2 a, glm::dvec2 b, double from, double to) {
      return (to - t) / (to - from) * a + (t - from) / (to - from) * b;
    };
    const glm::dvec2 a1 = mix(p[0], p[1], knot[0], knot[1]);
    const glm::dvec2 a2 = mix(p[1], p[2], knot[1], knot[2]);
    const glm::dvec2 a3 = mix(p[2], p[3], knot[2], knot[3]);
    const glm::dvec2 b1 = mix(a1, a2, knot[0], knot[2]);
    const glm::dvec2 b2 = mix(a2, a3, knot[1], knot[3]);
    EXPECT_LT(glm::length(curve.evaluate({1, share}).position - mix(b1, b2, knot[1], knot[2])), 1e-14);
  }
}

TEST(Curve, RefusesWhatIsNoCurveAndSaysWhy) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([] { bezier_curve<2>({{0, 0}}); }), "needs at least 2 control points, got 1");
  EXPECT_EQ(message_of([] { polyline<3>({{0, 0, 0}}, false); }), "needs at least 2 points, got 1");
  EXPECT_EQ(message_of([] { polyline<2>({{0, 0}, {1, 0}}, true); }), "needs at least 3 points, got 2");
  EXPECT_EQ(message_of([=] {
              polyline<2>({{0, 0}, {nan, 0}}, false);
            }),
            "needs finite coordinates, got NaN or infinity");
  EXPECT_EQ(message_of([] {
              polyline<2>({{1, 1}, {1, 1}}, false);
            }),
            "has no length: all its points are the same; give two that differ");
  EXPECT_EQ(message_of([] { circle_contour(0); }), "radius needs to be above 0 m, got 0");
  EXPECT_NE(message_of([] { polyline<2>({{0, 0}, {1e300, 0}}, false); }), "no error");
  EXPECT_NE(message_of([] { joined_bezier_curve<2>({{{0, 0}, {1, 0}}, {{2, 0}, {3, 0}}}); }), "no error");
}

}  // namespace
}  // namespace sweepkit::sweep
