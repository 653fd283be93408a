// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// What neither swallows nor gives light cannot be told from a white surround.

#include <gtest/gtest.h>

#include <cmath>

#include "tree_walk.hpp"

namespace sweepkit::render {
namespace {

using test::Grove;
using test::Stage;

std::string scene_of(const std::string& material, int depth, const std::string& object) {
  return R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 48, "height": 48},
    "background": [1, 1, 1], "ambient": [0, 0, 0], "depth": )" +
         std::to_string(depth) + R"(, "materials": {"m": {"diffuse": [0, 0, 0], )" + material +
         R"(}}, "objects": [{"name": "o", "material": "m", )" + object + "}]}";
}
const char* const kTorus =
    R"("tessellation": {"contour": 24, "trajectory": 48},
       "sweep": {"contour": {"circle": {"radius": 0.5}}, "trajectory": {"circle": {"radius": 1.2}}})";
const char* const kBall =
    R"("tessellation": {"contour": 32, "trajectory": 64},
       "revolve": {"contour": {"arc": {"radius": 1.2, "from_deg": -90, "to_deg": 90}}})";

// Every pixel is 1 but for what the depth cuts off; returns the largest such share.
double expect_white(const Stage& stage) {
  const Picture picture = stage.draw();
  const Grove grove(stage);
  double most = 0;
  for (int y = 0; y < 48; ++y) {
    const TreeRow row = grove.row(y);
    for (int x = 0; x < 48; ++x) {
      const double lost = test::share_cut_off(grove, row, row.root(x));
      most = std::max(most, lost);
      for (glm::length_t k = 0; k < 3; ++k)
        EXPECT_NEAR(picture.image.color(x, y)[k], 1 - lost, 1e-6) << x << ' ' << y;
    }
  }
  return most;
}

TEST(WhiteFurnace, AMirrorIsNotSeen) {
  EXPECT_LT(expect_white(Stage(scene_of(R"("reflect": 1)", 30, kTorus))), 1e-12);
}

TEST(WhiteFurnace, GlassIsNotSeenWhateverFresnelIs) {
  for (const char* material :
       {R"("reflect": 1, "transmit": 1, "ior": 1.5, "fresnel": "exact")",
        R"("reflect": 1, "transmit": 1, "ior": 1.5, "fresnel": "schlick")",
        R"("reflect": 1, "transmit": 1, "ior": 2.4, "fresnel": "exact")",
        R"("reflect": 0.25, "transmit": 0.75, "ior": 1.5)", R"("transmit": 1, "ior": 0.75)"}) {
    for (const char* object : {kTorus, kBall}) {
      // A quarter stays inside at each hit at the least, so half of what gets in is out after three levels:
      // at 16 levels only total reflection, which ends nowhere, holds light back.
      expect_white(Stage(scene_of(material, 16, object)));
    }
  }
}

TEST(WhiteFurnace, AShallowDepthCutsOffWhatABallHoldsInside) {
  // A ball's chord meets the surface at one angle all along: with F mirrored at each hit, (1 - F) F^(depth -
  // 1) is still inside. The mesh is off the ball by a facet's turn, 3 degrees, and F follows the angle.
  const Stage stage(scene_of(R"("reflect": 1, "transmit": 1, "ior": 1.5, "fresnel": "exact")", 3, kBall));
  const Grove grove(stage);
  const TreeRow row = grove.row(24);
  const double straight_on = 0.04;
  EXPECT_NEAR(test::share_cut_off(grove, row, row.root(24)), (1 - straight_on) * straight_on * straight_on,
              2e-4);
  expect_white(stage);
}

TEST(WhiteFurnace, ADeepTreeStaysSmall) {
  // Everything is split in halves, 64 levels deep: 2^64 leaves, were they all followed. Glass balls side by
  // side send light to and fro.
  std::string balls;
  for (int i = 0; i < 3; ++i) {
    balls += std::string(i > 0 ? "," : "") + R"({"name": "b)" + std::to_string(i) +
             R"(", "material": "m", "translate": [)" + std::to_string(2.05 * (i - 1)) +
             R"(, 0, 0], "tessellation": {"contour": 12, "trajectory": 24},
               "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}})";
  }
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 8, "height": 8},
    "background": [1, 1, 1], "ambient": [0, 0, 0], "depth": 64,
    "materials": {"m": {"diffuse": [0, 0, 0], "reflect": 0.5, "transmit": 0.5, "ior": 1.5}}, "objects": [)" +
      balls + "]}");
  const Grove grove(stage);
  const Picture picture = stage.draw();
  for (int y = 0; y < 8; ++y) {
    const TreeRow row = grove.row(y);
    // No more leaves than parts of kLeastWeight make a pixel, each at the end of a path of 64 nodes.
    EXPECT_LT(static_cast<double>(row.nodes.size()), 8 * 2 * 64 / kLeastWeight);
    for (int x = 0; x < 8; ++x) {
      const double lost = test::share_cut_off(grove, row, row.root(x));
      EXPECT_NEAR(picture.image.color(x, y).g, 1 - lost, 1e-6);
    }
  }
  EXPECT_EQ(test::texels(picture),
            test::texels(stage.draw({.threads = 1, .accelerator = Accelerator::kLinear})));
}

}  // namespace
}  // namespace sweepkit::render
