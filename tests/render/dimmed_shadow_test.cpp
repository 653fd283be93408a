// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "shadow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "draw.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

// The floor's colour at the picture's middle, lit through `objects` by a light from straight above; the eye
// stands beside them.
glm::vec3 floor_under(const std::string& materials, const std::string& objects) {
  return Stage(
             R"({"sweepkit": 1, "camera": {"eye": [0, 0.2, 6], "target": [0, 0, 0], "fov_deg": 1, "width": 5, "height": 5},
    "ambient": [0, 0, 0], "depth": 0, "lights": [{"directional": [0, -1, 0], "intensity": [1, 1, 1]}],
    "materials": {"white": {"diffuse": [1, 1, 1]}, )" +
             materials +
             R"(}, "objects": [{"name": "floor", "material": "white", "plane": {"size": [9, 9]}}, )" +
             objects + "]}")
      .draw()
      .image.color(2, 2);
}

TEST(DimmedShadow, ASheetLetsItsShareThrough) {
  const glm::vec3 under = floor_under(
      R"("sheet": {"diffuse": [0.2, 0.2, 0.2], "transmit": 0.6})",
      R"({"name": "sheet", "material": "sheet", "translate": [0, 1, 0], "plane": {"size": [2, 2]}})");
  EXPECT_NEAR(under.r, 0.6, 1e-6);
}

TEST(DimmedShadow, EverySheetOnTheWayTakesItsShare) {
  std::string sheets;
  for (int i = 0; i < 5; ++i) {
    sheets += std::string(i > 0 ? "," : "") + R"({"name": "s)" + std::to_string(i) +
              R"(", "material": "sheet", "rotate_deg": [)" + std::to_string(180 * (i % 2)) +
              R"(, 0, 0], "translate": [0, )" + std::to_string(1 + i) + R"(, 0], "plane": {"size": [2, 2]}})";
  }
  EXPECT_NEAR(floor_under(R"("sheet": {"diffuse": [0, 0, 0], "transmit": 0.5})", sheets).r, 1.0 / 32, 1e-7);
}

TEST(DimmedShadow, ABlockOfGlassDimsByItsThickness) {
  // 0.5 metres thick, straight through whatever the index.
  const glm::vec3 under =
      floor_under(R"("glass": {"diffuse": [0, 0, 0], "transmit": 0.9, "ior": 1.5, "absorption": [0, 1, 4]})",
                  R"({"name": "block", "material": "glass", "translate": [0, 1, 0],
          "sweep": {"contour": {"rectangle": {"width": 2, "height": 2}}, "trajectory": {"line": [[0, 0, 0], [0, 0.5, 0]]}}})");
  EXPECT_NEAR(under.r, 0.81, 1e-6);
  EXPECT_NEAR(under.g, 0.81 * std::exp(-0.5), 1e-6);
  EXPECT_NEAR(under.b, 0.81 * std::exp(-2), 1e-6);
}

TEST(DimmedShadow, WhatIsInsideIsDimmedByTheWayOut) {
  // The floor itself lies in the block, 0.25 metres below its top.
  const glm::vec3 under =
      floor_under(R"("glass": {"diffuse": [0, 0, 0], "transmit": 1, "absorption": [0, 1, 4]})",
                  R"({"name": "block", "material": "glass", "translate": [0, -0.25, 0],
          "sweep": {"contour": {"rectangle": {"width": 0.2, "height": 0.2}}, "trajectory": {"line": [[0, 0, 0], [0, 0.5, 0]]}}})");
  // The eye's ray is not followed through the block at depth 0, so look from light_passing() alone.
  EXPECT_EQ(under, glm::vec3(0));
  const Stage stage(
      R"({"sweepkit": 1, "materials": {"glass": {"diffuse": [0, 0, 0], "transmit": 1, "absorption": [0, 1, 4]}},
    "objects": [{"name": "block", "material": "glass", "sweep": {"contour": {"rectangle": {"width": 2, "height": 2}},
                 "trajectory": {"line": [[0, 0, 0], [0, 0.5, 0]]}}}]})");
  const Tracer tracer(stage.model.scene, false, Accelerator::kSeads);
  const auto passing = [&](const glm::dvec3& from, double end) {
    return light_passing(stage.model.scene, tracer, {from, {0, 1, 0}}, end);
  };
  EXPECT_NEAR(passing({0, 0.25, 0}, kNoEnd).b, std::exp(-4 * 0.25), 1e-7);
  EXPECT_NEAR(passing({0, 0.25, 0}, 10).b, std::exp(-4 * 0.25), 1e-7);
  // From below into the block, to a lamp inside it.
  EXPECT_NEAR(passing({0, -1, 0}, 1.125).b, std::exp(-4 * 0.125), 1e-7);
  EXPECT_EQ(passing({3, -1, 0}, kNoEnd), glm::dvec3(1.0));
}

TEST(DimmedShadow, WhatTransmitsNothingBlocks) {
  const glm::vec3 under = floor_under(
      R"("sheet": {"diffuse": [0, 0, 0], "transmit": 0.5})",
      R"({"name": "sheet", "material": "sheet", "translate": [0, 1, 0], "plane": {"size": [2, 2]}},
         {"name": "lid", "material": "white", "translate": [0, 2, 0], "plane": {"size": [2, 2]}})");
  EXPECT_EQ(under, glm::vec3(0));
}

}  // namespace
}  // namespace sweepkit::render
