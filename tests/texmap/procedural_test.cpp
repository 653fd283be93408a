// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/procedural.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sweepkit/texmap/noise.hpp"

namespace sweepkit::texmap {
namespace {

TEST(Noise, IsZeroAtWholeCoordinatesAndWithinOne) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> real(-100, 100);
  double largest = 0;
  for (int n = 0; n < 20000; ++n) {
    largest = std::max(largest, std::abs(noise({real(random), real(random), real(random)})));
    EXPECT_EQ(noise(glm::floor(glm::dvec3(real(random), real(random), real(random)))), 0);
  }
  EXPECT_LE(largest, 1.0 + 1e-12);
  EXPECT_GT(largest, 0.5);  // and does use its range
}

TEST(Noise, IsContinuousWithItsSlopeAcrossLatticePlanes) {
  const double h = 1e-5;
  for (const double y : {0.3, -4.7, 12.1}) {
    for (const int plane : {-3, 0, 5}) {
      const double before = (noise({plane - h, y, 0.4}) - noise({plane - 2 * h, y, 0.4})) / h;
      const double after = (noise({plane + 2 * h, y, 0.4}) - noise({plane + h, y, 0.4})) / h;
      // The quintic fade has a second derivative of 0 there: slopes h apart agree to second order of h.
      EXPECT_NEAR(before, after, 1e-3);
    }
  }
}

TEST(Noise, HasNoMeanAndDoesNotComeRoundAfter256) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> real(0, 200);
  double sum = 0;
  double same = 0;
  for (int n = 0; n < 20000; ++n) {
    const glm::dvec3 p(real(random), real(random), real(random));
    sum += noise(p);
    same += noise(p) == noise(p + glm::dvec3(256, 0, 0)) ? 1 : 0;
  }
  EXPECT_NEAR(sum / 20000, 0, 0.01);  // its deviation is about 0.25, so that of the mean 0.002
  EXPECT_LT(same / 20000, 0.2);       // one in twelve corners alike by chance
}

TEST(Procedural, RepeatsInTheUnitSquareWhereItSaysSo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> real(0, 1);
  int repeating = 0;
  for (const ProceduralKind kind :
       {ProceduralKind::kChecker, ProceduralKind::kTiles, ProceduralKind::kBands, ProceduralKind::kMarble}) {
    for (const double scale : {1.0, 2.0, 3.0, 8.0, 2.5}) {
      for (const std::size_t count : {0u, 2u, 3u, 5u}) {
        Procedural p{.kind = kind, .scale = scale};
        for (std::size_t i = 0; i < count; ++i) p.colors.push_back(glm::vec3(static_cast<float>(i) / 5));
        if (!repeats_in_unit_square(p)) continue;
        ++repeating;
        for (int n = 0; n < 100; ++n) {
          // Dyadic steps keep u + 1 exact.
          const glm::dvec2 uv =
              glm::floor(glm::dvec2(real(random), real(random)) * 4096.0) / 4096.0 + glm::dvec2(1.0 / 16384);
          EXPECT_EQ(evaluate(p, uv, {}), evaluate(p, uv + glm::dvec2(1, 0), {}));
          EXPECT_EQ(evaluate(p, uv, {}), evaluate(p, uv + glm::dvec2(0, 1), {}));
        }
      }
    }
  }
  EXPECT_GT(repeating, 20);
}

TEST(Procedural, CheckerAlternatesInCellsOfAHalf) {
  const Procedural checker{.kind = ProceduralKind::kChecker, .colors = {glm::vec3(0), glm::vec3(1)}};
  EXPECT_EQ(evaluate(checker, {0.25, 0.25}, {}).r, 0);
  EXPECT_EQ(evaluate(checker, {0.75, 0.25}, {}).r, 1);
  EXPECT_EQ(evaluate(checker, {0.75, 0.75}, {}).r, 0);
  EXPECT_EQ(evaluate(checker, {-0.25, 0.25}, {}).r, 1);
}

TEST(Procedural, BandsAreAsWideAsAsked) {
  const Procedural bands{
      .kind = ProceduralKind::kBands, .colors = {glm::vec3(0), glm::vec3(1)}, .widths = {3, 1}};
  EXPECT_EQ(evaluate(bands, {0.9, 0.74}, {}).r, 0);
  EXPECT_EQ(evaluate(bands, {0.1, 0.76}, {}).r, 1);
  EXPECT_EQ(evaluate(bands, {0.1, 1.74}, {}).r, 0);
}

TEST(Procedural, IsDefinedForEveryNumber) {
  for (const double x : {0.0, -0.0, 1e300, -1e300, 1e-300, HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    for (const ProceduralKind kind : {ProceduralKind::kChecker, ProceduralKind::kTiles,
                                      ProceduralKind::kBands, ProceduralKind::kMarble}) {
      for (const ProceduralOn on : {ProceduralOn::kUv, ProceduralOn::kPosition}) {
        const glm::vec3 color = evaluate({.kind = kind, .on = on}, {x, x}, {x, x, x});
        EXPECT_TRUE(color.r >= 0 && color.r <= 1);
      }
    }
  }
}

}  // namespace
}  // namespace sweepkit::texmap
