// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "scattering.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fresnel.hpp"

namespace sweepkit::render {
namespace {

struct Case {
  SurfacePoint point;
  glm::dvec3 direction;
};

// The face is up; a ray from above at any angle, down to a grazing millionth, and a shading normal as far off
// as a coarse mesh may have it.
Case random_case(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto around = [&](double height) {
    const double angle = 6.283185307179586 * uniform(random);
    const double radius = std::sqrt(1 - height * height);
    return glm::dvec3(radius * std::cos(angle), height, radius * std::sin(angle));
  };
  Case made{};
  made.point.face_normal = {0, 1, 0};
  made.point.shading_normal = around(1 - uniform(random) * uniform(random));
  made.direction = -around(std::pow(10.0, -6 * uniform(random)));
  return made;
}

TEST(BentNormal, KeepsEveryMirroredRayAboveTheFace) {
  std::mt19937 random(1);
  int bent = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto [point, direction] = random_case(random);
    const glm::dvec3 normal = bent_normal(point, direction);
    bent += normal != point.shading_normal ? 1 : 0;
    EXPECT_NEAR(glm::length(normal), 1, 1e-14);
    EXPECT_LT(glm::dot(normal, direction), 0);
    const glm::dvec3 out = mirrored(direction, normal);
    // Lifted to an eighth of the face's rise before it is made unit, which takes at most a factor of 1.01.
    EXPECT_GT(out.y, 0.98 * kLeastRise * -direction.y - 1e-15) << i;
  }
  EXPECT_GT(bent, 20000);
}

TEST(BentNormal, IsTheShadingNormalWhereThatWillDoAndBendsFromThereWithoutAJump) {
  // A ray at a fixed angle, the normal turned further and further along with it.
  SurfacePoint point{};
  point.face_normal = {0, 1, 0};
  const glm::dvec3 direction = glm::normalize(glm::dvec3(1, -0.2, 0.1));
  glm::dvec3 last(0.0);
  bool was_bent = false;
  for (int i = 0; i <= 10000; ++i) {
    const double turn = 0.8 * i / 10000;
    point.shading_normal = {std::sin(turn), std::cos(turn), 0};
    const glm::dvec3 normal = bent_normal(point, direction);
    if (i > 0) {
      // The normal turns by 8e-5, the mirrored ray by twice that; lifted from 80 degrees below the face it is
      // cos 80 = 0.17 long before it is made unit, and half of its turn is the bent normal's: 6 times 8e-5.
      EXPECT_LT(glm::length(normal - last), 4.8e-4) << i;
    }
    const bool is_bent = normal != point.shading_normal;
    EXPECT_TRUE(is_bent || !was_bent) << "it stays bent";
    was_bent = is_bent;
    last = normal;
  }
  EXPECT_TRUE(was_bent);
}

TEST(BentNormal, OfAFlatFaceIsTheFaces) {
  SurfacePoint point{};
  point.face_normal = point.shading_normal = {0, 1, 0};
  for (const double height : {1.0, 0.1, 1e-3, 1e-9, 1e-15})
    EXPECT_EQ(bent_normal(point, glm::normalize(glm::dvec3(1, -height, 0))), point.face_normal);
}

TEST(Refracted, LeadsBelowTheFaceAndIsSnells) {
  std::mt19937 random(2);
  for (int i = 0; i < 200000; ++i) {
    const auto [point, direction] = random_case(random);
    for (const double eta : {1 / 1.5, 1.5, 1 / 0.75}) {
      const glm::dvec3 normal = bent_normal(point, direction);
      const double cosine = -glm::dot(direction, normal);
      if (!(refracted_cosine(cosine, eta) > 0)) continue;
      const glm::dvec3 out = refracted(point, direction, normal, eta);
      EXPECT_NEAR(glm::length(out), 1, 1e-14);
      EXPECT_LE(out.y, 0) << i << ' ' << eta;
    }
    // A flat face: the sines are as the indices, and all lies in one plane.
    SurfacePoint flat = point;
    flat.shading_normal = flat.face_normal;
    const glm::dvec3 out = refracted(flat, direction, flat.face_normal, 1 / 1.5);
    EXPECT_NEAR(out.x, direction.x / 1.5, 1e-15);
    EXPECT_NEAR(out.z, direction.z / 1.5, 1e-15);
    EXPECT_EQ(refracted(point, direction, point.shading_normal, 1), direction);
  }
}

TEST(Absorbed, FallsByTheDistance) {
  scene::Material material;
  material.absorption = {0, 2, 0.5f};
  const glm::dvec3 left = absorbed(material, 3);
  EXPECT_EQ(left.r, 1);
  EXPECT_NEAR(left.g, std::exp(-6.0), 1e-16);
  EXPECT_NEAR(left.b, std::exp(-1.5), 1e-16);
}

}  // namespace
}  // namespace sweepkit::render
