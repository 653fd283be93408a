// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "supersampling.hpp"

#include <gtest/gtest.h>

#include "draw.hpp"

namespace sweepkit::render {
namespace {

TEST(Shrinker, HasThePapersWeightsForThreeByThree) {
  const double expected[3][3] = {
      {1.0 / 16, 1.0 / 8, 1.0 / 16}, {1.0 / 8, 1.0 / 4, 1.0 / 8}, {1.0 / 16, 1.0 / 8, 1.0 / 16}};
  for (int y = 0; y < 3; ++y) {
    for (std::size_t x = 0; x < 3; ++x) {
      Shrinker shrinker(3, 1);
      for (int k = 0; k < 3; ++k) {
        std::vector<glm::dvec4> row(3, glm::dvec4(0.0));
        if (k == y) row[x] = glm::dvec4(1.0);
        shrinker.add(k, row);
      }
      float rgb[3];
      shrinker.take(rgb, 3);
      EXPECT_EQ(rgb[0], expected[y][x]);
    }
  }
}

TEST(Shrinker, KeepsAConstantPictureConstantForEveryFactor) {
  for (int n = 1; n <= 16; ++n) {
    Shrinker shrinker(n, 2);
    for (int k = 0; k < n; ++k)
      shrinker.add(k, std::vector<glm::dvec4>(static_cast<std::size_t>(2 * n), glm::dvec4(0.7)));
    float rgba[8];
    shrinker.take(rgba, 4);
    for (const float value : rgba) EXPECT_NEAR(value, 0.7f, 1e-7);  // n^2 roundings of weights that sum to 1
  }
}

TEST(Supersampling, BringsAnEdgeToItsCoverage) {
  // A white half plane whose edge runs through the middle of a column of pixels.
  const test::Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 1, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov_deg": 90, "width": 9, "height": 9},
    "ambient": [1, 1, 1], "materials": {"white": {"diffuse": [1, 1, 1]}},
    "objects": [{"name": "half", "material": "white", "translate": [5, 0, 0], "plane": {"size": [10, 10]}}]})");
  EXPECT_EQ(stage.draw({.supersampling = 16}).image.color(4, 4).r, 0.5f);
  EXPECT_EQ(stage.draw({.supersampling = 16}).image.color(3, 4).r, 0.0f);
}

}  // namespace
}  // namespace sweepkit::render
