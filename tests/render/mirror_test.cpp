// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "draw.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

TEST(Mirror, ShowsAnObjectWhereItsImageStands) {
  // A small bright ball in front of a mirror in the plane z = 0: its image stands as far behind it.
  const std::string scene =
      R"({"sweepkit": 1, "camera": {"eye": [0.5, 0, 6], "target": [0.5, 0, 0], "fov_deg": 40, "width": 101, "height": 101},
    "ambient": [1, 1, 1], "depth": 1, "materials": {"mirror": {"diffuse": [0, 0, 0], "reflect": 1}, "ball": {"diffuse": [1, 0, 0]}},
    "objects": [{"name": "mirror", "material": "mirror", "rotate_deg": [90, 0, 0], "plane": {"size": [20, 20]}},
      {"name": "ball", "material": "ball", "translate": [1.5, 0, 2], "tessellation": {"contour": 24, "trajectory": 48},
       "revolve": {"contour": {"free": [[0, -0.2], [0.1414, -0.1414], [0.2, 0], [0.1414, 0.1414], [0, 0.2]]}}}]})";
  const Picture picture = Stage(scene).draw();
  const double scale = 50.5 / std::tan(20 * 3.14159265358979 / 180);
  // Seen from (0.5, 0, 6) the ball stands 1 to the right at distance 4, its image 1 to the right at
  // distance 8.
  const int direct = static_cast<int>(50.5 + scale * 1 / 4);
  const int image = static_cast<int>(50.5 + scale * 1 / 8);
  EXPECT_EQ(picture.image.color(direct, 50), glm::vec3(1, 0, 0));
  EXPECT_EQ(picture.image.color(image, 50), glm::vec3(1, 0, 0));
  EXPECT_EQ(picture.image.color(10, 50), glm::vec3(0, 0, 0));
}

TEST(Mirror, AllMirrorsInAWhiteSurroundAreWhite) {
  const std::string scene =
      R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 64, "height": 64},
    "background": [1, 1, 1], "ambient": [0, 0, 0], "depth": 30, "materials": {"mirror": {"diffuse": [0, 0, 0], "reflect": 1}},
    "objects": [{"name": "torus", "material": "mirror", "sweep": {"contour": {"circle": {"radius": 0.5}}, "trajectory": {"circle": {"radius": 1.2}}}}]})";
  const Picture picture = Stage(scene).draw();
  for (const float value : test::texels(picture)) EXPECT_NEAR(value, 1, 1e-6);
}

TEST(Mirror, AddsNothingAtTheDeepestLevel) {
  // Two parallel mirrors face each other: every ray ends at the depth, with nothing to show.
  const std::string scene =
      R"({"sweepkit": 1, "camera": {"eye": [0, 0.5, 0], "target": [0, 0, 0], "up": [0, 0, 1], "fov_deg": 20, "width": 16, "height": 16},
    "background": [1, 1, 1], "ambient": [0, 0, 0], "depth": 4, "materials": {"mirror": {"diffuse": [0, 0, 0], "reflect": 1}},
    "objects": [{"name": "below", "material": "mirror", "plane": {"size": [100, 100]}},
                {"name": "above", "material": "mirror", "translate": [0, 1, 0], "plane": {"size": [100, 100]}}]})";
  const Picture picture = Stage(scene).draw();
  for (const float value : test::texels(picture)) EXPECT_EQ(value, 0);
  EXPECT_EQ(picture.statistics.reflected_rays, 4u * 16 * 16);
}

TEST(Mirror, SumsAGeometricSeriesBetweenAmbientWalls) {
  // Each level adds its ambient light times the shares before it: 0.5 (1 + 0.5 + 0.25) at depth 2.
  const std::string scene =
      R"({"sweepkit": 1, "camera": {"eye": [0, 0.5, 0], "target": [0, 0, 0], "up": [0, 0, 1], "fov_deg": 20, "width": 8, "height": 8},
    "ambient": [1, 1, 1], "depth": 2, "materials": {"grey": {"diffuse": [0.5, 0.5, 0.5], "reflect": 0.5}},
    "objects": [{"name": "below", "material": "grey", "plane": {"size": [100, 100]}},
                {"name": "above", "material": "grey", "translate": [0, 1, 0], "plane": {"size": [100, 100]}}]})";
  const Picture picture = Stage(scene).draw();
  for (const float value : test::texels(picture)) EXPECT_NEAR(value, 0.875, 1e-6);
}

}  // namespace
}  // namespace sweepkit::render
