// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/heat_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh_shapes.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::texmap {
namespace {

using test::Shape;

MappedSurface surface_of(const Shape& shape) {
  return {shape.positions, shape.texcoords, shape.triangles};
}

// CIE 1976 lightness, a formula other than the ramp's own, from relative luminance (Rec. 709).
double cie_lightness(const glm::vec3& color) {
  const double y = 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389.0 / 27;
}

TEST(HeatColor, GetsLighterInNearlyEvenSteps) {
  const double range = cie_lightness(heat_color(1)) - cie_lightness(heat_color(0));
  EXPECT_GT(range, 75);
  for (int i = 0; i < 20; ++i) {
    const double step = cie_lightness(heat_color((i + 1) / 20.0)) - cie_lightness(heat_color(i / 20.0));
    // OKLab and CIE Lab disagree on the lightness of saturated blue and red by some 40 % of a step.
    EXPECT_GT(step, 0.55 * range / 20) << i;
    EXPECT_LT(step, 1.5 * range / 20) << i;
  }
}

// Clamping would flatten the ramp; the constants of the conversion have 10 digits.
TEST(HeatColor, StaysInsideTheScreensColours) {
  for (int i = 0; i <= 1000; ++i) {
    const glm::vec3 color = heat_color(i / 1000.0);
    for (glm::length_t k = 0; k < 3; ++k) {
      EXPECT_GT(color[k], 0) << i;
      EXPECT_LT(color[k], 1) << i;
    }
  }
  EXPECT_EQ(heat_color(-3), heat_color(0));
  EXPECT_EQ(heat_color(std::numeric_limits<double>::infinity()), heat_color(1));
}

TEST(HeatMap, ShowsEachTriangleWhereItLies) {
  const Shape plane = test::plane(4, 4);
  std::vector<double> ratios;
  for (std::size_t t = 0; t < plane.triangles.size(); ++t) ratios.push_back(t % 2 == 0 ? 1 : 8);
  const HeatMap map = draw_heat_map(surface_of(plane), ratios, {64, 64});
  EXPECT_EQ(map.low, glm::dvec2(0));
  EXPECT_EQ(map.high, glm::dvec2(1));
  EXPECT_EQ(map.brightest, 8);
  for (std::size_t t = 0; t < plane.triangles.size(); ++t) {
    glm::dvec2 middle(0.0);
    for (const std::uint32_t vertex : plane.triangles[t]) middle += glm::dvec2(plane.texcoords[vertex]) / 3.0;
    const glm::vec3 color =
        map.image.color(static_cast<int>(64 * middle.x), static_cast<int>(64 * (1 - middle.y)));
    const glm::vec3 expected = heat_color(t % 2 == 0 ? 0 : 1);
    for (glm::length_t k = 0; k < 3; ++k) EXPECT_NEAR(color[k], expected[k], 1.0 / 65535);
  }
}

// A quarter of the texture is covered; the rest is filled from its nearest texel.
TEST(HeatMap, LeavesNoTexelEmpty) {
  Shape plane = test::plane(4, 4);
  for (glm::vec2& uv : plane.texcoords) uv *= 0.5f;
  const std::vector<double> ratios(plane.triangles.size(), 3.0);
  const HeatMap map = draw_heat_map(surface_of(plane), ratios, {33, 17});
  for (int y = 0; y < 17; ++y) {
    for (int x = 0; x < 33; ++x) EXPECT_EQ(map.image.color(x, y), map.image.color(0, 16));
  }
}

TEST(HeatMap, ShowsTheLargerRatioWhereTrianglesOverlap) {
  Shape plane = test::plane(1, 1);
  const auto once = plane.triangles;
  plane.triangles.insert(plane.triangles.end(), once.begin(), once.end());
  const HeatMap map = draw_heat_map(surface_of(plane), std::vector<double>{4, 4, 1, 1}, {8, 8});
  EXPECT_NEAR(map.image.color(3, 3).r, heat_color(1).r, 1e-4);
}

TEST(HeatMap, CoversWholeSquaresOfTheTexture) {
  Shape plane = test::plane(2, 2);
  for (glm::vec2& uv : plane.texcoords) uv = uv * glm::vec2(2.5f, 1.0f) - glm::vec2(0.25f, 0.0f);
  const HeatMap map =
      draw_heat_map(surface_of(plane), std::vector<double>(plane.triangles.size(), 1.0), {4, 4});
  EXPECT_EQ(map.low, glm::dvec2(-1, 0));
  EXPECT_EQ(map.high, glm::dvec2(3, 1));
  EXPECT_EQ(map.brightest, 1.1);
}

TEST(HeatMap, RefusesSizesAndTextureCoordinatesOutOfRange) {
  Shape plane = test::plane(1, 1);
  EXPECT_THROW(draw_heat_map(surface_of(plane), std::vector<double>(2, 1.0), {0, 5}), InputError);
  EXPECT_THROW(draw_heat_map(surface_of(plane), std::vector<double>(2, 1.0), {5, 32769}), InputError);
  plane.texcoords[0].x = 3e6f;
  EXPECT_THROW(draw_heat_map(surface_of(plane), std::vector<double>(2, 1.0)), InputError);
}

}  // namespace
}  // namespace sweepkit::texmap
