// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Procedural textures under footprints: near ones against the point, far ones against the mean over many
// points, and a plane to the horizon against a supersampled one.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "color_ramp.hpp"
#include "sweepkit/texmap/procedural.hpp"
#include "tent_steps.hpp"

namespace sweepkit::texmap {
namespace {

constexpr std::size_t kKindCount = kProceduralNames.size();

Procedural of_kind(std::size_t kind, ProceduralOn on) {
  return {.kind = static_cast<ProceduralKind>(kind), .on = on};
}

double largest(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

TEST(TentSteps, AgreeWithQuadratureForEveryWidth) {
  for (const double h : {1e-9, 0.01, 0.2, 0.499, 0.501, 0.7, 1.0, 3.3, 40.0}) {
    for (const double x : {-2.3, 0.0, 0.25, 0.5, 0.77, 5.0, 1e6 + 0.4}) {
      // Midpoints of 2,000 cells of a function with 2 h + 1 jumps of 1, each at a weight below 1 / h: every
      // jump is misplaced by half a cell of h / 1000 at most.
      constexpr int kCells = 2000;
      double sum = 0;
      for (int i = 0; i < kCells; ++i) {
        const double t = (2 * i + 1.0) / kCells - 1;
        const double f = x + h * t;
        sum += (1 - std::abs(t)) * (f - std::floor(f) >= 0.3 && f - std::floor(f) < 0.8 ? 1 : 0);
      }
      EXPECT_NEAR(filtered_pulse(x, 0.3, 0.8, h), sum * 2 / kCells, 0.0005 * (4 * h + 2)) << x << " " << h;
    }
  }
}

// The box's mean is the length of the pulses in it.
TEST(TentSteps, OfABoxAreWhatPulsesCoverOfIt) {
  for (const double h : {1e-9, 0.01, 0.2, 0.499, 0.501, 0.7, 1.0, 3.3, 40.0}) {
    for (const double x : {-2.3, 0.0, 0.25, 0.5, 0.77, 5.0, 1e6 + 0.4}) {
      double covered = 0;
      for (double cell = std::floor(x - h); cell <= x + h; ++cell)
        covered += std::max(0.0, std::min(x + h, cell + 0.8) - std::max(x - h, cell + 0.3));
      // At a million a double has 2^-33 of a unit, in a box of 2e-9 a share of 0.06.
      const double rounding = 1e-9 + 4 * std::abs(x) * 0x1p-52 / h;
      EXPECT_NEAR(filtered_pulse(x, 0.3, 0.8, h, FilterShape::kBox), covered / (2 * h), rounding)
          << x << " " << h;
    }
  }
}

TEST(TentSteps, OfBothFormsMeet) {
  for (int i = 0; i < 100; ++i) {
    const double x = 0.01 * i;
    EXPECT_NEAR(filtered_floor(x, 0.5), filtered_floor(x, std::nextafter(0.5, 1)), 1e-12);
  }
}

TEST(ColorRamp, OfANormalSpreadAgreesWithQuadrature) {
  const std::array<RampKnot, 3> knots = {RampKnot{-0.4, {0, 0.1f, 1}}, RampKnot{0.1, {1, 0.3f, 0}},
                                         RampKnot{0.3, {0.2f, 0.9f, 0.5f}}};
  const auto knot = [&](std::size_t i) { return knots[i]; };
  for (const double sigma : {0.01, 0.1, 0.5, 2.0}) {
    for (const double t : {-1.0, -0.4, 0.0, 0.15, 0.6}) {
      glm::dvec3 ramp(0.0);
      glm::dvec3 wave(0.0);
      double weights = 0;
      for (int step = -8 * 512; step <= 8 * 512; ++step) {
        const double z = step / 512.0;
        const double weight = std::exp(-0.5 * z * z);
        ramp += weight * mean_of_ramp(t + sigma * z, {}, 3, knot);
        wave += weight * mean_of_wave(t + sigma * z, 0, 3, [&](std::size_t i) {
                  return RampKnot{knots[i].at + 0.4, knots[i].color};
                });
        weights += weight;
      }
      // The trapezoid rule on a kinked function: the step squared times a slope of 8.
      EXPECT_LT(largest(mean_of_ramp(t, {sigma * sigma, 0, 0}, 3, knot) - ramp / weights), 1e-4);
      const glm::dvec3 filtered = mean_of_wave(t, sigma, 3, [&](std::size_t i) {
        return RampKnot{knots[i].at + 0.4, knots[i].color};
      });
      EXPECT_LT(largest(filtered - wave / weights), 2e-4) << sigma << " " << t;
    }
  }
}

// What a footprint has taken from an octave by fading it to `a` of itself (fractal_noise.cpp): near by nearly
// nothing, whose shape may not count for more than its size. A normal spread moves a kink by
// sigma / sqrt(2 pi), a skewness of 0.8 by at most 0.04 sigma more, a kurtosis of 0.5 by 0.01 sigma.
TEST(ColorRamp, AKinkIsBluntedByNoMoreThanTheSpread) {
  for (const double left : {0.5, 1e-2, 1e-4, 1e-6, 1e-9}) {
    const double a = 1 - left;
    const Cumulants lost{0.0729 * (1 - a * a), 0.00265 * (1 - a * a * a), -0.00243 * (1 - a * a * a * a)};
    const double sigma = std::sqrt(lost.variance);
    for (int i = -70; i <= 70; ++i) {
      const double t = 0.1 * i * sigma;
      EXPECT_NEAR(mean_kink(t, lost), std::max(0.0, t), 0.45 * sigma) << left << " " << i;
    }
  }
}

TEST(ProceduralFilter, NearByIsThePoint) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> real(0, 3);
  for (std::size_t kind = 0; kind < kKindCount; ++kind) {
    for (const ProceduralOn on : {ProceduralOn::kUv, ProceduralOn::kPosition}) {
      const Procedural procedural = of_kind(kind, on);
      for (int n = 0; n < 500; ++n) {
        const glm::dvec3 at(real(random), real(random), on == ProceduralOn::kUv ? 0.0 : real(random));
        const glm::vec3 point = evaluate(procedural, {at});
        const glm::vec3 pixel = evaluate(procedural, {at, {1e-7, 2e-8, 0}, {-1e-8, 1e-7, 0}});
        // Of 500 places one in 10,000 has an edge within 1e-7. The finest noise, granite's, has 160 cells a
        // unit and edges of a quarter of its deviation: a slope of 4,000 a unit; its spread is sqrt(3) 1e-7
        // 160, over the edge 2e-4.
        EXPECT_LT(largest(glm::dvec3(pixel - point)), 1e-3) << kProceduralNames[kind];
      }
    }
  }
}

TEST(ProceduralFilter, FarOffIsTheMeanWhereverItLies) {
  for (std::size_t kind = 0; kind < kKindCount; ++kind) {
    for (const ProceduralOn on : {ProceduralOn::kUv, ProceduralOn::kPosition}) {
      const Procedural procedural = of_kind(kind, on);
      const glm::dvec3 mean(mean_of(procedural));
      for (int n = 0; n < 50; ++n) {
        const glm::dvec3 at(0.731 * n, 0.113 * n, on == ProceduralOn::kUv ? 0.0 : 0.317 * n);
        const PatternFootprint wide{at, {3e4, 1e4, 7e3}, {-1e4, 3e4, 2e4}};
        EXPECT_LT(largest(glm::dvec3(evaluate(procedural, wide)) - mean), 1e-4) << kProceduralNames[kind];
      }
    }
  }
}

// Askew footprints are cut into at most 31 pieces whose shadows on the axes are taken apart.
TEST(ProceduralFilter, AgreesWithQuadratureForFootprintsOfEveryDirection) {
  constexpr int kSide = 64;
  Procedural checker = of_kind(0, ProceduralOn::kUv);
  checker.colors = {glm::vec3(0), glm::vec3(1)};
  double along = 0;
  double askew = 0;
  for (int n = 0; n < 300; ++n) {
    const double angle = (n % 3 == 0 ? 0.0 : 0.37 * n);
    const glm::dvec3 dx = (0.05 + 0.004 * n) * glm::dvec3(std::cos(angle), std::sin(angle), 0);
    const glm::dvec3 dy = 0.15 * glm::dvec3(-std::sin(angle), std::cos(angle), 0);
    const glm::dvec3 at(0.173 * n, 0.391 * n, 0);
    double sum = 0;
    double weights = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
      const int row = i / kSide;
      const glm::dvec2 t((2 * (i % kSide) + 1.0) / kSide - 1, (2 * row + 1.0) / kSide - 1);
      const double weight = (1 - std::abs(t.x)) * (1 - std::abs(t.y));
      sum += weight * evaluate(checker, {at + t.x * dx + t.y * dy}).r;
      weights += weight;
    }
    const double error = std::abs(evaluate(checker, {at, dx, dy}).r - sum / weights);
    (n % 3 == 0 ? along : askew) = std::max(n % 3 == 0 ? along : askew, error);
  }
  // Along the axes it is exact: what is left is the quadrature's, a jump misplaced by 1/64 of the tent's top
  // along each of the two axes at most. Askew the pieces' corners are missing: measured, 0.055.
  EXPECT_LT(along, 2.0 / kSide);
  EXPECT_LT(askew, 0.07);
}

}  // namespace
}  // namespace sweepkit::texmap
