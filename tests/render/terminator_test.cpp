// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Where a light grazes a coarse smooth mesh, its picture is held against the one of a fine mesh.

#include <gtest/gtest.h>

#include <cmath>

#include "draw.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

constexpr int kSide = 160;

Picture draw(const std::string& shape, int contour, int trajectory, const std::string& light) {
  return Stage(
             R"({"sweepkit": 1, "camera": {"eye": [0, 5, 8], "target": [0, 0, 0], "fov_deg": 17, "width": 160, "height": 160},
    "background": [0, 0, 1], "ambient": [0, 0, 0], "lights": [{"directional": )" +
             light + R"(, "intensity": [1, 1, 1]}], "materials": {"m": {"diffuse": [1, 1, 0]}},
    "objects": [{"name": "o", "material": "m", "tessellation": {"contour": )" +
             std::to_string(contour) + R"(, "trajectory": )" + std::to_string(trajectory) + "}, " + shape +
             "}]}")
      .draw();
}

// Root mean square difference of the pixels that are near the terminator in the fine picture, lit by less
// than a quarter, and whose neighbourhood is on the object and not in a cast shadow's edge in either.
double rmse_near_terminator(const Picture& coarse, const Picture& fine) {
  double sum = 0;
  int count = 0;
  for (int y = 3; y < kSide - 3; ++y) {
    for (int x = 3; x < kSide - 3; ++x) {
      const double value = fine.image.color(x, y).r;
      bool is_near = value > 0.02 && value < 0.25;
      for (int j = -3; j <= 3 && is_near; ++j) {
        for (int i = -3; i <= 3; ++i) {
          is_near &= coarse.image.color(x + i, y + j).b == 0 && fine.image.color(x + i, y + j).b == 0;
          is_near &= std::abs(fine.image.color(x + i, y + j).r - value) < 0.2;
        }
      }
      if (!is_near) continue;
      ++count;
      const double off = coarse.image.color(x, y).r - value;
      sum += off * off;
    }
  }
  EXPECT_GT(count, 200);
  return std::sqrt(sum / count);
}

TEST(Terminator, ACoarseBallIsLitAsAFineOne) {
  const std::string ball = R"("revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}})";
  const std::string light = "[-1, -0.15, -0.12]";
  const double rmse = rmse_near_terminator(draw(ball, 8, 16, light), draw(ball, 128, 256, light));
  RecordProperty("rmse", std::to_string(rmse));
  // A pixel shows the coarse ball's place, up to 1 - cos 11 degrees = 0.02 nearer to the middle, and the
  // light's slope across the picture is about 1: a few thousandths. A facet in its own shadow is off by 0.1.
  EXPECT_LT(rmse, 0.005);
}

TEST(Terminator, ACoarseSaddleIsLitAsAFineOne) {
  // The neck of a vase, which curves both ways.
  const std::string vase =
      R"("revolve": {"contour": {"bezier": [[0.3, -1], [1.4, -0.5], [0.1, 0.3], [0.7, 1]]}})";
  const std::string light = "[-1, -0.15, -0.12]";
  const double rmse = rmse_near_terminator(draw(vase, 10, 16, light), draw(vase, 160, 256, light));
  RecordProperty("rmse", std::to_string(rmse));
  // The same, with facets twice as far from the surface. Without the dips left out it is 0.0123: black
  // outlines of facets.
  EXPECT_LT(rmse, 0.009);
}

TEST(Terminator, NoLightLeaksThroughAThinWall) {
  // A coarse hollow ball whose wall is a fiftieth of its facets' length: a lamp inside leaves the outside
  // dark, one outside the inside.
  const auto shell = [](const char* eye, const char* lamp) {
    return Stage(R"({"sweepkit": 1, "camera": {"eye": )" + std::string(eye) +
                 R"(, "target": [0, 0, 0], "fov_deg": 70, "width": 96, "height": 96}, "ambient": [0, 0, 0],
      "lights": [{"point": )" +
                 lamp + R"(, "intensity": [1, 1, 1]}], "materials": {"m": {"diffuse": [1, 1, 1]}},
      "objects": [{"name": "shell", "material": "m", "parts": [
        {"tessellation": {"contour": 9, "trajectory": 12}, "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}},
        {"tessellation": {"contour": 9, "trajectory": 12}, "revolve": {"contour": {"arc": {"radius": 0.99, "from_deg": 90, "to_deg": -90}}}}]}]})")
        .draw();
  };
  for (const Picture& picture :
       {shell("[0, 1, 4]", "[0.5, 0.1, 0]"), shell("[0, 0.2, 0.5]", "[3, 0.1, 0]")}) {
    double most = 0;
    for (const float value : test::texels(picture)) most = std::max(most, static_cast<double>(value));
    EXPECT_EQ(most, 0);
  }
}

}  // namespace
}  // namespace sweepkit::render
