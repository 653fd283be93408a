// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/latitude_longitude.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sweepkit::texmap {
namespace {

glm::dvec2 place_of(const glm::dvec3& direction) {
  return over_sphere(glm::normalize(direction), glm::dvec3(0.0), glm::dvec3(0.0), {64, 32}).uv;
}

TEST(OverSphere, PutsTheAxesWhereTheHeaderSays) {
  // The upper half of v is the picture: its middle row is v = 3/4, +Y the top, -Y the middle of the whole.
  const double quarter = 0.25;
  EXPECT_EQ(place_of({0, 0, -1}), glm::dvec2(0.5, 3 * quarter));
  EXPECT_EQ(place_of({1, 0, 0}), glm::dvec2(0.75, 3 * quarter));
  EXPECT_EQ(place_of({-1, 0, 0}), glm::dvec2(0.25, 3 * quarter));
  EXPECT_EQ(place_of({0, 1, 0}).y, 1);
  EXPECT_EQ(place_of({0, -1, 0}).y, 0.5);
  // The borders meet at +Z.
  EXPECT_NEAR(place_of({1e-12, 0, 1}).x, 1, 1e-12);
  EXPECT_NEAR(place_of({-1e-12, 0, 1}).x, 0, 1e-12);
}

TEST(OverSphere, StepsAreTheDerivativesOfThePlace) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> real(-1, 1);
  for (int n = 0; n < 1000; ++n) {
    const glm::dvec3 d = glm::normalize(glm::dvec3(real(random), 0.8 * real(random), real(random)));
    // Away from the border at +Z and from the poles, where steps are held short.
    if (std::hypot(d.x, d.z) < 0.3 || (d.z > 0 && std::abs(d.x) < 1e-3)) continue;
    const glm::dvec3 any(real(random), real(random), real(random));
    const glm::dvec3 turn = any - glm::dot(any, d) * d;
    const glm::dvec3 other = glm::cross(d, turn);
    const Footprint footprint = over_sphere(d, turn, other, {64, 32});
    // Central differences: wrong by h^2 of the third derivative, which is below 1e3 here, and by rounding /
    // h.
    const double h = 1e-5;
    const auto slope = [&](const glm::dvec3& way) {
      return (place_of(d + h * way) - place_of(d - h * way)) / (2 * h);
    };
    EXPECT_LT(glm::length(footprint.dx - slope(turn)), 1e-6);
    EXPECT_LT(glm::length(footprint.dy - slope(other)), 1e-6);
  }
}

TEST(OverSphere, StepsNearAPoleAreNoLongerThanSixteenTexelsForEachAcross) {
  for (const double h : {1e-3, 1e-9, 1e-300, 0.0}) {
    const glm::dvec3 d = glm::normalize(glm::dvec3(h, 1, 0));
    const Footprint footprint = over_sphere(d, {0.01, 0, 0}, {0, 0, 0.01}, {64, 32});
    const double across = 64.0 * std::max(std::abs(footprint.dx.y), std::abs(footprint.dy.y));
    EXPECT_GT(across, 0);
    EXPECT_LE(64 * std::abs(footprint.dx.x), 16 * across * (1 + 1e-12));
    EXPECT_LE(64 * std::abs(footprint.dy.x), 16 * across * (1 + 1e-12));
    EXPECT_TRUE(std::isfinite(footprint.uv.x + footprint.uv.y));
  }
}

}  // namespace
}  // namespace sweepkit::texmap
