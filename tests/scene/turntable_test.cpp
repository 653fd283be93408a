// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/turntable.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sweepkit/scene/model.hpp"

namespace sweepkit::scene {
namespace {

const Camera kCamera{.eye = {3, 2, 4}, .target = {1, 0.5, -2}, .up = {0.25, 1, 0}, .fov_deg = 30};

TEST(Turned, CarriesTheEyeRoundTheTargetCounterClockwiseFromAbove) {
  // (2, 1.5, 6) from the target; a quarter turn about +Y takes z to x and x to -z.
  const Camera quarter = turned(kCamera, 90);
  EXPECT_EQ(quarter.eye, glm::dvec3(1 + 6, 2, -2 - 2));
  EXPECT_EQ(quarter.up, glm::dvec3(0, 1, -0.25));
  EXPECT_EQ(quarter.target, kCamera.target);
  EXPECT_EQ(quarter.fov_deg, 30);
}

TEST(Turned, ByNoneOrAFullTurnIsTheCameraItself) {
  for (const double degrees : {0.0, 360.0}) {
    EXPECT_EQ(turned(kCamera, degrees).eye, kCamera.eye);
    EXPECT_EQ(turned(kCamera, degrees).up, kCamera.up);
  }
}

TEST(Turned, KeepsDistanceAndHeightAtEveryAngle) {
  for (double degrees = 0; degrees < 360; degrees += 3) {
    const Camera camera = turned(kCamera, degrees);
    // A product of a 3 x 3 matrix whose entries are rounded once: a few roundings of the distance, 6.5.
    EXPECT_NEAR(glm::distance(camera.eye, camera.target), glm::distance(kCamera.eye, kCamera.target), 1e-14);
    EXPECT_EQ(camera.eye.y, kCamera.eye.y);
    const double angle = std::atan2(camera.eye.x - 1, camera.eye.z + 2) - std::atan2(2.0, 6.0);
    const double turns = angle / (2 * std::numbers::pi) - degrees / 360;
    EXPECT_NEAR(turns, std::nearbyint(turns), 1e-15);
  }
}

TEST(LookFrom, TakesTheDefaultLightAlongAndLeavesTheScenesOwn) {
  const auto build_scene = [](const std::string& more) {
    return parse_document(R"({"sweepkit": 1, "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}, )" + more +
                              R"("objects": [{"name": "p", "plane": {"size": [1, 1]}}]})",
                          "test.json");
  };
  const Document plain = build_scene("");
  Model model = build(plain, plan(plain, {}));
  const auto light = [&] { return std::get<DirectionalLight>(model.scene.lights.at(0)).direction; };
  const glm::dvec3 before = light();
  look_from(model.scene, plain, turned(model.scene.camera, 90));
  EXPECT_EQ(model.scene.camera.eye, glm::dvec3(5, 0, 0));
  EXPECT_LT(glm::distance(light(), glm::dvec3(before.z, before.y, -before.x)), 1e-15);

  const Document lit = build_scene(R"("lights": [{"directional": [0, -1, 0]}], )");
  model = build(lit, plan(lit, {}));
  look_from(model.scene, lit, turned(model.scene.camera, 90));
  EXPECT_EQ(light(), glm::dvec3(0, -1, 0));
  const Document ambient = build_scene(R"("ambient": [1, 1, 1], )");
  model = build(ambient, plan(ambient, {}));
  look_from(model.scene, ambient, turned(model.scene.camera, 90));
  EXPECT_TRUE(model.scene.lights.empty());
}

}  // namespace
}  // namespace sweepkit::scene
