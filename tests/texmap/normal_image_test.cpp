// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/normal_image.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sweepkit::texmap {
namespace {

// Half a step of 16 bits, over the range of 2.
constexpr double kHalfStep = 1.0 / 65535;

glm::dvec3 normal_of(const Image& image, int x, int y) {
  return 2.0 * glm::dvec3(image.color(x, y)) - 1.0;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double bound) {
  for (glm::length_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], bound);
}

Image heights(int width, int height, const auto& height_at) {
  Image image = make_float_image(width, height, 1);
  auto out = std::get<std::vector<float>>(image.texels).begin();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) *out++ = static_cast<float>(height_at(x, y));
  }
  return image;
}

// 0 + 0.02 x - 0.01 y (down): slopes are the same at the edges, and v runs upwards.
TEST(NormalImage, APlaneOfHeightsHasItsNormalUpToTheEdges) {
  const Image image = heights(8, 6, [](int x, int y) { return 0.3 + 0.02 * x - 0.01 * y; });
  const Image normals = normals_from_heights(image, {.texel = {0.5, 0.25}, .depth = 3});
  const glm::dvec3 expected = glm::normalize(glm::dvec3(-3 * 0.02 / 0.5, -3 * 0.01 / 0.25, 1));
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) expect_near(normal_of(normals, x, y), expected, kHalfStep + 1e-6);
  }
}

// A central difference of sin(p x) is cos(p x) sin(p) for a step of 1: exact, and round the edge too.
TEST(NormalImage, AWaveThatRepeatsHasTheNormalsOfItsDifferencesWithoutASeam) {
  const double p = 2 * std::numbers::pi / 32;
  const Image image = heights(32, 4, [&](int x, int) { return 0.5 + 0.5 * std::sin(p * x); });
  const Image normals = normals_from_heights(
      image, {.texel = {1, 1}, .depth = 2, .repeats_across = true, .repeats_down = true});
  for (int x = 0; x < 32; ++x) {
    expect_near(normal_of(normals, x, 2), glm::normalize(glm::dvec3(-std::cos(p * x) * std::sin(p), 0, 1)),
                kHalfStep + 1e-6);
  }
}

TEST(NormalImage, ANegativeDepthTurnsHillsIntoDents) {
  const Image image = heights(4, 4, [](int x, int) { return 0.1 * x; });
  const glm::dvec3 hill = normal_of(normals_from_heights(image, {.depth = 1}), 1, 1);
  const glm::dvec3 dent = normal_of(normals_from_heights(image, {.depth = -1}), 1, 1);
  EXPECT_LT(hill.x, 0);
  expect_near(dent, glm::dvec3(-hill.x, hill.y, hill.z), 2 * kHalfStep);
}

// Black and white cross each other at 45 degrees: as colours their mean is shorter than a normal.
TEST(NormalImage, ShrinkingTakesTheMeanVectorAndMakesItUnit) {
  Image image{2, 1, 3, std::vector<std::uint16_t>()};
  auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
  for (const glm::dvec3& n : {glm::dvec3(0.8, 0, 0.6), glm::dvec3(0, 0, 1)}) {
    for (glm::length_t k = 0; k < 3; ++k)
      texels.push_back(static_cast<std::uint16_t>(std::lround(65535 * 0.5 * (n[k] + 1))));
  }
  const glm::dvec3 mean = glm::normalize(glm::dvec3(0.8, 0, 1.6));
  expect_near(normal_of(shrink_normals(image, {1, 1}), 0, 0), mean, 4 * kHalfStep);
}

TEST(NormalImage, NormalsThatCancelOutBecomeStraightUp) {
  Image image = make_float_image(2, 1);
  std::get<std::vector<float>>(image.texels) = {1, 0.5f, 0.5f, 0, 0.5f, 0.5f};
  expect_near(normal_of(shrink_normals(image, {1, 1}), 0, 0), {0, 0, 1}, 1e-6);
}

}  // namespace
}  // namespace sweepkit::texmap
