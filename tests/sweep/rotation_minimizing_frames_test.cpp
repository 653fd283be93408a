// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "rotation_minimizing_frames.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "sweepkit/sweep/primitives.hpp"

namespace sweepkit::sweep {
namespace {

constexpr double kPi = std::numbers::pi;

// A truncated Taylor series: a value with its first three derivatives by u.
struct Jet {
  std::array<double, 4> d{};
};
Jet operator+(const Jet& a, const Jet& b) {
  return {{a.d[0] + b.d[0], a.d[1] + b.d[1], a.d[2] + b.d[2], a.d[3] + b.d[3]}};
}
Jet operator*(const Jet& a, const Jet& b) {
  return {{a.d[0] * b.d[0], a.d[1] * b.d[0] + a.d[0] * b.d[1],
           a.d[2] * b.d[0] + 2 * a.d[1] * b.d[1] + a.d[0] * b.d[2],
           a.d[3] * b.d[0] + 3 * a.d[2] * b.d[1] + 3 * a.d[1] * b.d[2] + a.d[0] * b.d[3]}};
}
Jet constant(double c) {
  return {{c, 0, 0, 0}};
}
Jet cosine(double k, double u) {
  return {{std::cos(k * u), -k * std::sin(k * u), -k * k * std::cos(k * u), k * k * k * std::sin(k * u)}};
}
Jet sine(double k, double u) {
  return {{std::sin(k * u), k * std::cos(k * u), -k * k * std::sin(k * u), -k * k * k * std::cos(k * u)}};
}

using JetCurve = std::function<std::array<Jet, 3>(double)>;

std::array<Jet, 3> helix(double u) {
  return {cosine(1, u), sine(1, u), Jet{{u / 2, 0.5, 0, 0}}};
}
std::array<Jet, 3> knot(double u) {
  const Jet r = constant(0.6) + constant(0.3) * cosine(7, u);
  return {r * cosine(2, u), r * sine(2, u), constant(0.3) * sine(7, u)};
}
std::array<Jet, 3> bezier(double u) {
  const Jet t{{u, 1, 0, 0}};
  const Jet s{{1 - u, -1, 0, 0}};
  const std::array<glm::dvec3, 4> p = {glm::dvec3(0, 0, 0), {1, 2, 0}, {3, -1, 2}, {4, 1, 1}};
  std::array<Jet, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<glm::length_t>(k);
    out[k] = constant(p[0][i]) * s * s * s + constant(3 * p[1][i]) * s * s * t +
             constant(3 * p[2][i]) * s * t * t + constant(p[3][i]) * t * t * t;
  }
  return out;
}

glm::dvec3 derivative(const std::array<Jet, 3>& at, std::size_t order) {
  return {at[0].d[order], at[1].d[order], at[2].d[order]};
}

struct Frenet {
  glm::dvec3 position, tangent, normal, binormal;
  double torsion_rate;  // torsion times speed
};

Frenet frenet(const JetCurve& curve, double u) {
  const std::array<Jet, 3> at = curve(u);
  const glm::dvec3 r1 = derivative(at, 1);
  const glm::dvec3 r2 = derivative(at, 2);
  const glm::dvec3 cross = glm::cross(r1, r2);
  const glm::dvec3 t = glm::normalize(r1);
  const glm::dvec3 b = glm::normalize(cross);
  const double torsion = glm::dot(cross, derivative(at, 3)) / glm::dot(cross, cross);
  return {derivative(at, 0), t, glm::cross(b, t), b, torsion * glm::length(r1)};
}

// The exact frame is Frenet's turned by minus the integral of torsion (Simpson's rule, 64 panels a step).
double largest_error(const JetCurve& curve, double end, int steps) {
  Frenet here = frenet(curve, 0);
  glm::dvec3 carried = here.normal;
  double angle = 0;
  double worst = 0;
  for (int i = 1; i <= steps; ++i) {
    const double from = end * (i - 1) / steps;
    const double to = end * i / steps;
    const int panels = 64;
    const double h = (to - from) / panels;
    for (int k = 0; k < panels; ++k) {
      const double u = from + k * h;
      angle += h / 6 *
               (frenet(curve, u).torsion_rate + 4 * frenet(curve, u + h / 2).torsion_rate +
                frenet(curve, u + h).torsion_rate);
    }
    const Frenet next = frenet(curve, to);
    carried = double_reflection(carried, {here.position, here.tangent}, {next.position, next.tangent});
    const glm::dvec3 exact = std::cos(angle) * next.normal - std::sin(angle) * next.binormal;
    const glm::dvec3 exact_b = glm::cross(next.tangent, exact);
    worst = std::max(worst, std::abs(std::atan2(glm::dot(carried, exact_b), glm::dot(carried, exact))));
    here = next;
  }
  return worst;
}

// The figures of Wang et al.'s method measured for three curves: helix, a knot, a cubic.
TEST(DoubleReflection, ReproducesTheKnownErrorsWithinTenPercent) {
  EXPECT_NEAR(largest_error(helix, 4 * kPi, 64), 1.857e-6, 0.1 * 1.857e-6);
  EXPECT_NEAR(largest_error(helix, 4 * kPi, 256), 7.255e-9, 0.1 * 7.255e-9);
  EXPECT_NEAR(largest_error(knot, 2 * kPi, 256), 2.034e-5, 0.1 * 2.034e-5);
  EXPECT_NEAR(largest_error(knot, 2 * kPi, 1024), 7.955e-8, 0.1 * 7.955e-8);
  EXPECT_NEAR(largest_error(bezier, 1, 64), 2.270e-8, 0.1 * 2.270e-8);
}

TEST(DoubleReflection, IsOfFourthOrder) {
  const double order = std::log2(largest_error(knot, 2 * kPi, 512) / largest_error(knot, 2 * kPi, 1024));
  EXPECT_NEAR(order, 4, 0.1);
}

TEST(DoubleReflection, KeepsTheNormalWhereNothingMoves) {
  const TangentPoint point{{1, 2, 3}, {0, 0, 1}};
  EXPECT_EQ(double_reflection({1, 0, 0}, point, point), glm::dvec3(1, 0, 0));
}

TEST(FirstFrame, TakesUpForTheBinormalAndMinusZAlongUp) {
  const Frame level = first_frame({0, 0, 1}, {0, 1, 0});
  EXPECT_EQ(level.binormal, glm::dvec3(0, 1, 0));
  EXPECT_EQ(level.normal, glm::dvec3(1, 0, 0));
  for (const double sign : {1.0, -1.0})
    EXPECT_EQ(first_frame({0, sign, 0}, {0, 1, 0}).binormal, glm::dvec3(0, 0, -1));
}

TEST(FirstFrame, IsAsPerpendicularWhereUpIsAlmostAlongTheWay) {
  // A single projection leaves the rounding of `up` over the sine: 1e-10 at a millionth of a radian.
  for (const double beside : {1e-1, 1e-3, 1e-5, 2e-6}) {
    const glm::dvec3 tangent = glm::normalize(glm::dvec3(beside, 1, 0.3 * beside));
    const Frame frame = first_frame(tangent, {0, 1, 0});
    EXPECT_NEAR(glm::dot(frame.binormal, tangent), 0, 4e-16) << beside;
    EXPECT_NEAR(glm::length(frame.normal), 1, 4e-16) << beside;
  }
}

TEST(RotationMinimizingFrames, DoNotDependOnHowCoarseTheMeshIs) {
  const Curve3 curve = bezier_curve<3>({{0, 0, 0}, {1, 2, 0}, {3, -1, 2}, {4, 1, 1}});
  const glm::dvec3 coarse =
      rotation_minimizing_frames(curve, place_stations(curve, 2)).back().in.frame.normal;
  const glm::dvec3 fine =
      rotation_minimizing_frames(curve, place_stations(curve, 500)).back().in.frame.normal;
  // Each of up to 500 steps agrees with its own halving to 1e-12.
  EXPECT_LT(glm::length(coarse - fine), 1e-9);
}

// A vector and its rate on the trefoil ((R + r cos 3s) cos 2s, r sin 3s, -(R + r cos 3s) sin 2s), in long
// double.
struct LongVector {
  long double x, y, z;

  LongVector plus(long double k, const LongVector& v) const {
    return {x + k * v.x, y + k * v.y, z + k * v.z};
  }
  long double dot(const LongVector& v) const { return x * v.x + y * v.y + z * v.z; }
};

// n' = -(t' . n) t: what a rotation-minimizing frame's normal obeys.
LongVector normal_rate(long double s, const LongVector& n) {
  constexpr long double kRing = 1;
  constexpr long double kTube = 0.4;  // as the double is that torus_knot() gets
  const long double a = kRing + kTube * std::cos(3 * s);
  const long double da = -3 * kTube * std::sin(3 * s);
  const long double dda = -9 * kTube * std::cos(3 * s);
  const long double c = std::cos(2 * s);
  const long double d = std::sin(2 * s);
  const LongVector first{da * c - 2 * a * d, 3 * kTube * std::cos(3 * s), -(da * d + 2 * a * c)};
  const LongVector second{dda * c - 4 * da * d - 4 * a * c, -9 * kTube * std::sin(3 * s),
                          -(dda * d + 4 * da * c - 4 * a * d)};
  const long double speed = std::sqrt(first.dot(first));
  const LongVector t = LongVector{0, 0, 0}.plus(1 / speed, first);
  const LongVector bend = second.plus(-second.dot(t), t);
  return LongVector{0, 0, 0}.plus(-bend.dot(n) / speed, t);
}

TEST(RotationMinimizingFrames, OfATrefoilAreRightToABillionthAt4096Steps) {
  constexpr int kSteps = 4096;
  const Curve3 knot = torus_knot(2, 3, 1, 0.4);
  const std::vector<Station> stations = place_stations(knot, kSteps);
  const std::vector<StationFrames> frames = rotation_minimizing_frames(knot, stations, {0, 1, 0});
  const glm::dvec3 start = frames.front().out.frame.normal;
  LongVector n{start.x, start.y, start.z};
  long double s = 0;
  double worst = 0;
  for (std::size_t i = 1; i < stations.size(); ++i) {
    const long double end = i + 1 == stations.size() ? 2 * std::numbers::pi_v<long double>
                                                     : 2 * std::numbers::pi_v<long double> * stations[i].in.t;
    // Runge and Kutta's method of fourth order; 16 steps of a 65,536th of the knot are off by some 1e-16.
    const long double h = (end - s) / 16;
    for (int k = 0; k < 16; ++k, s += h) {
      const LongVector k1 = normal_rate(s, n);
      const LongVector k2 = normal_rate(s + h / 2, n.plus(h / 2, k1));
      const LongVector k3 = normal_rate(s + h / 2, n.plus(h / 2, k2));
      const LongVector k4 = normal_rate(s + h, n.plus(h, k3));
      n = n.plus(h / 6, k1).plus(h / 3, k2).plus(h / 3, k3).plus(h / 6, k4);
    }
    s = end;
    const glm::dvec3 difference = frames[i].in.frame.normal - glm::dvec3(n.x, n.y, n.z);
    worst = std::max(worst, glm::length(difference));
  }
  // A billionth is promised; the step is halved until it is far below.
  EXPECT_LT(worst, 1e-11);
}

TEST(RotationMinimizingFrames, AreOrthonormalAndRightHandedEverywhere) {
  const Curve3 curve = free_curve<3>({{0, 0, 0}, {1, 3, 0}, {1, 3, 2}, {-2, 0, 1}}, true);
  for (const StationFrames& station : rotation_minimizing_frames(curve, place_stations(curve, 100))) {
    const Frame& f = station.out.frame;
    // A few roundings of unit vectors.
    EXPECT_LT(glm::length(glm::cross(f.normal, f.binormal) - f.tangent), 1e-14);
    EXPECT_NEAR(glm::length(f.normal), 1, 1e-14);
  }
}

TEST(RotationMinimizingFrames, StayFiniteOnCuspsAndReversals) {
  const Curve3 cusp = bezier_curve<3>({{1, -1, 0}, {-1.0 / 3, 1, 0}, {-1.0 / 3, -1, 0}, {1, 1, 0}});
  for (const StationFrames& station : rotation_minimizing_frames(cusp, place_stations(cusp, 10))) {
    EXPECT_TRUE(std::isfinite(station.in.frame.normal.x) && std::isfinite(station.in.frame.binormal.y));
    EXPECT_NEAR(glm::length(station.in.frame.normal), 1, 1e-12);
  }
}

}  // namespace
}  // namespace sweepkit::sweep
