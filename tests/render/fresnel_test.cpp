// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "fresnel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sweepkit::render {
namespace {

// By the angles, in twice the precision: Fresnel's sine and tangent laws.
long double by_angles(long double angle, long double eta) {
  const long double beyond = std::asin(eta * std::sin(angle));
  const long double s = std::sin(angle - beyond) / std::sin(angle + beyond);
  const long double p = std::tan(angle - beyond) / std::tan(angle + beyond);
  return (s * s + p * p) / 2;
}

TEST(Fresnel, ExactAgreesWithTheSineAndTangentLaws) {
  for (const double index : {0.75, 1.0003, 1.33, 1.5, 2.4, 10.0}) {
    for (const double eta : {1 / index, index}) {
      for (int i = 1; i < 900; ++i) {
        const long double angle = i * std::numbers::pi_v<long double> / 1800;
        if (eta * std::sin(angle) >= 1) continue;
        const auto cosine = static_cast<double>(std::cos(angle));
        const long double expected = by_angles(angle, eta);
        // Rounding of the cosine is magnified by the slope, 1 / beyond towards the critical angle.
        const double beyond = refracted_cosine(cosine, eta);
        EXPECT_NEAR(fresnel_exact(cosine, beyond, eta), static_cast<double>(expected),
                    1e-14 / (beyond * beyond * cosine))
            << index << ' ' << i;
      }
    }
  }
}

TEST(Fresnel, StraightOnIsTheSquareOfTheIndexRatio) {
  EXPECT_NEAR(fresnel_exact(1, refracted_cosine(1, 1 / 1.5), 1 / 1.5), 0.04, 1e-15);
  EXPECT_NEAR(fresnel_exact(1, refracted_cosine(1, 1.5), 1.5), 0.04, 1e-15);
  EXPECT_NEAR(fresnel_schlick(1, refracted_cosine(1, 1.5), 1.5), 0.04, 1e-15);
}

TEST(Fresnel, BrewstersAngleMirrorsOneHalfOfTheSineLaw) {
  // tan angle = 1.5: the other polarization is not mirrored, and the rays are at right angles.
  const double angle = std::atan(1.5);
  const double s = std::cos(2 * angle);  // sin(angle - beyond) / 1
  EXPECT_NEAR(fresnel_exact(std::cos(angle), refracted_cosine(std::cos(angle), 1 / 1.5), 1 / 1.5), s * s / 2,
              1e-14);
}

TEST(Fresnel, IsOneBeyondTheCriticalAngleAndAtGrazing) {
  const double critical = std::asin(1 / 1.5);
  for (const double angle : {critical + 1e-6, critical + 0.1, 1.5}) {
    const double beyond = refracted_cosine(std::cos(angle), 1.5);
    EXPECT_EQ(beyond, 0);
    EXPECT_EQ(fresnel_exact(std::cos(angle), beyond, 1.5), 1);
    EXPECT_EQ(fresnel_schlick(std::cos(angle), beyond, 1.5), 1);
  }
  EXPECT_NEAR(fresnel_exact(0, refracted_cosine(0, 1 / 1.5), 1 / 1.5), 1, 1e-15);
  EXPECT_NEAR(fresnel_schlick(0, refracted_cosine(0, 1 / 1.5), 1 / 1.5), 1, 1e-15);
}

TEST(Fresnel, IsTheSameFromEitherSide) {
  for (int i = 0; i <= 100; ++i) {
    const double cosine = 0.01 * i;
    const double beyond = refracted_cosine(cosine, 1 / 1.5);
    EXPECT_NEAR(fresnel_exact(cosine, beyond, 1 / 1.5), fresnel_exact(beyond, cosine, 1.5), 1e-13);
    // Schlick's takes the cosine in the air both ways.
    EXPECT_NEAR(fresnel_schlick(cosine, beyond, 1 / 1.5), fresnel_schlick(beyond, cosine, 1.5), 1e-13);
  }
}

TEST(Fresnel, SchlickIsNearTheExactShareOfGlass) {
  // Its known error: at most 0.04 for an index of 1.5, near 85 degrees.
  for (int i = 0; i <= 100; ++i) {
    const double beyond = refracted_cosine(0.01 * i, 1 / 1.5);
    EXPECT_NEAR(fresnel_schlick(0.01 * i, beyond, 1 / 1.5), fresnel_exact(0.01 * i, beyond, 1 / 1.5), 0.04);
  }
}

TEST(Fresnel, NoBoundaryMirrorsNothing) {
  for (const double cosine : {0.0, 1e-9, 0.5, 1.0}) {
    EXPECT_EQ(fresnel_exact(cosine, refracted_cosine(cosine, 1), 1), 0);
    EXPECT_EQ(fresnel_schlick(cosine, refracted_cosine(cosine, 1), 1), 0);
  }
}

}  // namespace
}  // namespace sweepkit::render
