// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_lights.hpp"

#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "parsed_gltf.hpp"

namespace sweepkit::scene {
namespace {

constexpr double kPi = std::numbers::pi;

// A floor of 2 x 2 m about the origin: the middle of all is 0, the radius sqrt(2).
std::string lit(const std::string& lights) {
  return scene_text(R"("materials": {"m": {}}, "lights": [)" + lights + "]",
                    R"({"name": "floor", "plane": {"size": [2, 2]}})");
}

json lights_of(const Parsed& parsed) {
  return parsed.root["extensions"]["KHR_lights_punctual"]["lights"];
}

TEST(GltfLights, ADirectionalLightIsPiTimesItsIntensityInLux) {
  const Parsed parsed = glb(lit(R"({"directional": [0, -1, 0], "intensity": [0.5, 2, 1]})"));
  const json light = lights_of(parsed).at(0);
  EXPECT_EQ(light["type"], "directional");
  EXPECT_EQ(light["color"], (json{0.25, 1.0, 0.5}));
  EXPECT_DOUBLE_EQ(light["intensity"], 2 * kPi);
  EXPECT_EQ(parsed.root["extensionsUsed"], json{"KHR_lights_punctual"});
  EXPECT_FALSE(parsed.root.contains("extensionsRequired"));
}

TEST(GltfLights, APointLightIsRightAtTheDistanceOfTheMiddleOfAll) {
  const Parsed parsed = glb(lit(R"({"point": [0, 3, 4], "intensity": [0.8, 0.8, 0.8]})"));
  const json light = lights_of(parsed).at(0);
  EXPECT_EQ(light["type"], "point");
  EXPECT_NEAR(light["intensity"].get<double>() / 25, 0.8 * kPi, 1e-6) << "0.8 is a float32";
  EXPECT_FALSE(light.contains("range"));
  const json& node = parsed.root["nodes"].back();
  EXPECT_EQ(node["translation"], (json{0.0, 3.0, 4.0}));
  EXPECT_EQ(node["extensions"]["KHR_lights_punctual"]["light"], 0);
}

TEST(GltfLights, APointLightInTheMiddleIsRightAtHalfTheRadius) {
  const Parsed parsed = glb(lit(R"({"point": [0, 0, 0], "intensity": [1, 1, 1]})"));
  EXPECT_NEAR(lights_of(parsed).at(0)["intensity"].get<double>(), kPi * 0.5, 1e-12);
}

TEST(GltfLights, ShineTheWayThatTheyShineInTheScene) {
  for (const glm::dvec3& way : {glm::dvec3(0, -1, 0), glm::dvec3(1, 2, 3), glm::dvec3(0, 0, -2),
                                glm::dvec3(0, 0, 5), glm::dvec3(1e-7, 0, 1)}) {
    const json direction = {way.x, way.y, way.z};
    const Parsed parsed = glb(lit(R"({"directional": )" + direction.dump() + "}"));
    const json& node = parsed.root["nodes"].back();
    const auto q = node.value("rotation", std::vector<double>{0, 0, 0, 1});
    const glm::dvec3 shines = glm::dquat(q[3], q[0], q[1], q[2]) * glm::dvec3(0, 0, -1);
    // A quaternion near the opposite way loses half the digits of a double.
    EXPECT_LT(glm::distance(shines, glm::normalize(way)), 1e-7) << direction;
  }
}

TEST(GltfLights, AreLeftOutWhereNothingWouldBeLit) {
  const std::string text = lit(R"({"directional": [0, -1, 0]})");
  for (const GltfLook look : {GltfLook::kUnlit, GltfLook::kCompatible}) {
    const Parsed parsed = glb(text, {.bake_size = 32, .look = look});
    EXPECT_FALSE(parsed.root.contains("extensions"));
    EXPECT_EQ(parsed.root["nodes"].size(), 2u);
  }
  EXPECT_FALSE(glb(lit(R"({"directional": [0, -1, 0], "intensity": [0, 0, 0]})")).root.contains("extensions"))
      << "a black light";
  EXPECT_FALSE(glb(scene_text(R"("materials": {"m": {}})", kVase)).root.contains("extensions"))
      << "the light of a scene without any is the picture's, not its own";
}

TEST(GltfLights, TheCamerasNearAndFarHoldTheSphereAboutEverything) {
  const std::string floor = R"({"name": "floor", "plane": {"size": [2, 2]}})";
  const auto camera = [&](const std::string& text) {
    const json perspective = glb(text).root["cameras"][0]["perspective"];
    return std::pair(perspective["znear"].get<double>(), perspective["zfar"].get<double>());
  };
  const double radius = std::sqrt(2.0);
  const auto [near, far] = camera(scene_text(R"("camera": {"eye": [0, 0, 10], "target": [0, 0, 0]})", floor));
  EXPECT_DOUBLE_EQ(near, (10 - radius) / 2);
  EXPECT_DOUBLE_EQ(far, (10 + radius) * 2);
  const auto [inner, outer] =
      camera(scene_text(R"("camera": {"eye": [0, 1, 0], "target": [0, 0, 0]})", floor));
  EXPECT_DOUBLE_EQ(inner, 0.001);
  EXPECT_DOUBLE_EQ(outer, (1 + radius) * 2);
  // The picture's own camera has the sphere in view.
  const auto [first, last] = camera(scene_text(R"("materials": {"m": {}})", floor));
  EXPECT_GT(first, 0.1 * radius);
  EXPECT_LT(last / first, 100);
}

}  // namespace
}  // namespace sweepkit::scene
