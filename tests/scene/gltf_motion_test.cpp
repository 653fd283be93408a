// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_motion.hpp"

#include <cmath>
#include <numbers>

#include "parsed_gltf.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<float> floats(const Parsed& parsed, std::size_t index, std::size_t per) {
  const json& accessor = parsed.root["accessors"][index];
  std::vector<float> values(accessor["count"].get<std::size_t>() * per);
  std::memcpy(values.data(), parsed.view(accessor["bufferView"]), values.size() * sizeof(float));
  return values;
}

std::string swept(const std::string& shape, const std::string& more = "") {
  return R"({"name": "x", "tessellation": {"contour": 8, "trajectory": 32}, "sweep": {)" + shape + "}" +
         more + "}";
}

const std::string kRod =
    swept(R"("contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0, 0, 0], [0, 2, 0]]})");
const std::string kArc = swept(
    R"("contour": {"circle": {"radius": 0.1}}, "trajectory": {"arc": {"radius": 1, "from_deg": 0, "to_deg": 180}})");

TEST(Turntable, HasAKeyEveryThirtyDegreesOfTheClosedForm) {
  const auto keys = turn_keys();
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const double half = kPi * static_cast<double>(k) / 12;
    // float32's own rounding, half a unit in the last place of 1
    EXPECT_NEAR(keys[k].y, std::sin(half), 6e-8);
    EXPECT_NEAR(keys[k].w, std::cos(half), 6e-8);
    EXPECT_EQ(keys[k].x, 0);
    EXPECT_EQ(keys[k].z, 0);
    if (k > 0) {
      EXPECT_GT(glm::dot(keys[k], keys[k - 1]), 0) << "the short way from key to key";
    }
  }
  EXPECT_EQ(keys.back(), -keys.front()) << "the same place";
}

TEST(Turntable, AStraightWayBetweenKeysIsOffByLessThanThirtyFourThousandthsOfADegree) {
  const auto keys = turn_keys();
  double most = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double share = i / 1000.0;
    const glm::dvec4 at = glm::mix(glm::dvec4(keys[0]), glm::dvec4(keys[1]), share);
    most = std::max(most, std::abs(2 * std::atan2(at.y, at.w) * 180 / kPi - 30 * share));
  }
  EXPECT_LT(most, 0.034);
  EXPECT_GT(most, 0.030) << "the header would say too much";
}

TEST(Turntable, TurnsTheObjectsAboutTheMiddleOfAllAndNotTheCamera) {
  const std::string floor = R"({"name": "floor", "translate": [10, 3, -4], "plane": {"size": [2, 2]}})";
  const std::string two =
      R"({"name": "two", "instances": [{"translate": [7, 3, -4]}, {"translate": [13, 3, -4]}], "plane": {"size": [1, 1]}})";
  const std::string text = scene_text(R"("lights": [{"directional": [0, -1, 0]}])", floor + ", " + two);
  const Parsed still = glb(text);
  const Parsed parsed = glb(text, {.bake_size = 32, .turntable_seconds = 8});
  const json& nodes = parsed.root["nodes"];
  const json& top = parsed.root["scenes"][0]["nodes"];
  ASSERT_EQ(top.size(), 3u) << "the turntable, the camera, the light";
  const json& turntable = nodes[top[0].get<std::size_t>()];
  EXPECT_EQ(turntable["name"], "turntable");
  EXPECT_EQ(turntable["translation"], (json{10.0, 3.0, -4.0}));
  EXPECT_EQ(turntable["children"].size(), 2u);
  EXPECT_EQ(nodes[top[1].get<std::size_t>()]["name"], "camera");
  EXPECT_EQ(nodes[top[1].get<std::size_t>()]["translation"],
            still.root["nodes"][still.root["scenes"][0]["nodes"][2].get<std::size_t>()]["translation"]);
  // At rest everything is where it is without a turntable.
  const json& group = nodes[turntable["children"][1].get<std::size_t>()];
  EXPECT_EQ(nodes[group["children"][0].get<std::size_t>()]["translation"], (json{-3.0, 0.0, 0.0}));
  EXPECT_EQ(nodes[group["children"][1].get<std::size_t>()]["translation"], (json{3.0, 0.0, 0.0}));
  const json& animation = parsed.root["animations"][0];
  EXPECT_EQ(animation["channels"][0]["target"]["node"], top[0]);
  EXPECT_EQ(animation["channels"][0]["target"]["path"], "rotation");
  const json& sampler = animation["samplers"][0];
  EXPECT_EQ(sampler["interpolation"], "LINEAR");
  const auto times = floats(parsed, sampler["input"], 1);
  ASSERT_EQ(times.size(), 13u);
  EXPECT_EQ(times.front(), 0);
  EXPECT_EQ(times[6], 4);
  EXPECT_EQ(times.back(), 8);
}

// The mesh as a viewer shows it at a time, by the file's own numbers.
struct Shown {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
};

Shown at_time(const Parsed& parsed, double seconds) {
  const json& animation = parsed.root["animations"][0];
  const auto times = floats(parsed, animation["samplers"][0]["input"], 1);
  const auto outputs = floats(parsed, animation["samplers"][0]["output"], 1);
  const json& primitive = parsed.primitive();
  const std::size_t targets = primitive["targets"].size();
  EXPECT_EQ(outputs.size(), targets * times.size());
  std::size_t k = 0;
  while (k + 2 < times.size() && times[k + 1] <= seconds) ++k;
  const double share = (seconds - times[k]) / (times[k + 1] - times[k]);
  Shown shown;
  const auto add = [&](std::vector<glm::dvec3>& to, std::size_t accessor, double weight) {
    const auto values = floats(parsed, accessor, 3);
    to.resize(values.size() / 3, glm::dvec3(0.0));
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] += weight * glm::dvec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
  };
  add(shown.positions, primitive["attributes"]["POSITION"], 1);
  add(shown.normals, primitive["attributes"]["NORMAL"], 1);
  for (std::size_t target = 0; target < targets; ++target) {
    const double weight =
        (1 - share) * outputs[k * targets + target] + share * outputs[(k + 1) * targets + target];
    add(shown.positions, primitive["targets"][target]["POSITION"], weight);
    add(shown.normals, primitive["targets"][target]["NORMAL"], weight);
  }
  for (glm::dvec3& normal : shown.normals) normal = glm::normalize(normal);
  return shown;
}

glm::dvec3 origin_of(const Parsed& parsed) {
  const json place = parsed.root["nodes"][0].value("translation", json{0.0, 0.0, 0.0});
  return {place[0], place[1], place[2]};
}

TEST(Grow, AStraightRodNeedsOneTargetAndIsExactlyAsLongAsTheTimeTells) {
  const Parsed parsed = glb(scene_text("", kRod), {.bake_size = 32, .grow_seconds = 4});
  EXPECT_EQ(parsed.file.targets, 1u);
  // The mesh's own float32: 2 m in steps of 1.2e-7.
  EXPECT_LT(parsed.file.grow_error, 1e-6);
  const double base = origin_of(parsed).y;
  for (const double seconds : {0.0, 1.0, 2.0, 3.5, 4.0}) {
    const Shown shown = at_time(parsed, seconds);
    double top = -1;
    for (const glm::dvec3& p : shown.positions) {
      top = std::max(top, p.y + base);
      EXPECT_NEAR(std::hypot(p.x + origin_of(parsed).x, p.z + origin_of(parsed).z), 0.1, 1e-6);
    }
    EXPECT_NEAR(top, 2 * seconds / 4, 1e-6);
  }
}

TEST(Grow, HalfOfAnArcIsThereAtHalfTheTimeWithinTheErrorTold) {
  const Parsed parsed = glb(scene_text("", kArc), {.bake_size = 32, .grow_seconds = 2});
  const double error = parsed.file.grow_error;
  // 2 % of a diagonal of 2.2 x 0.2 x 1.1 m for the middle, 10 % of 0.1 m for the points about it.
  EXPECT_LT(error, 0.02 * 2.48 + 0.01);
  EXPECT_GT(parsed.file.targets, 1u);
  for (const double seconds : {0.3, 1.0, 1.7}) {
    const double angle = kPi * seconds / 2;
    double farthest = 0;
    const Shown shown = at_time(parsed, seconds);
    for (std::size_t i = 0; i < shown.positions.size(); ++i) {
      const glm::dvec3 p = shown.positions[i] + origin_of(parsed);
      farthest = std::max(farthest, std::atan2(-p.z, p.x));
      // On the tube, whose middle is the arc of radius 1.
      const glm::dvec3 center = glm::normalize(glm::dvec3(p.x, 0, p.z));
      EXPECT_LT(glm::distance(p, center), 0.1 + error + 1e-6);
    }
    // At the inner side, 0.9 m from the axis, the error is the largest angle.
    EXPECT_NEAR(farthest, angle, (error + 1e-6) / 0.9);
  }
}

TEST(Grow, NormalsStayPerpendicularToWhatHasGrown) {
  const Parsed parsed = glb(scene_text("", kArc), {.bake_size = 32, .grow_seconds = 2});
  const auto indices = parsed.accessor<std::uint16_t>(parsed.primitive()["indices"]);
  const auto worst = [&](double seconds) {
    const Shown shown = at_time(parsed, seconds);
    double least = 1;
    for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
      const glm::dvec3& a = shown.positions[indices[t]];
      const glm::dvec3 face =
          glm::cross(shown.positions[indices[t + 1]] - a, shown.positions[indices[t + 2]] - a);
      if (glm::length(face) < 1e-6) continue;  // not there yet
      for (std::size_t k = 0; k < 3; ++k)
        least = std::min(least, glm::dot(glm::normalize(face), shown.normals[indices[t + k]]));
    }
    return least;
  };
  // A facet of an eighth of a circle is 22.5 degrees from its corners' normals; growing may add 10 to that.
  const double whole = worst(2.0);
  EXPECT_NEAR(whole, std::cos(22.5 * kPi / 180), 0.02);
  for (const double seconds : {0.11, 0.5, 0.93, 1.3, 1.77})
    EXPECT_GT(worst(seconds), std::cos(32.5 * kPi / 180)) << seconds;
}

TEST(Grow, ARevolveGrowsRoundItsTurn) {
  const Parsed parsed =
      glb(scene_text(R"("materials": {"m": {}})", kVase), {.bake_size = 32, .grow_seconds = 1});
  const Shown half = at_time(parsed, 0.5);
  const glm::dvec3 origin = origin_of(parsed);
  const double error = parsed.file.grow_error;
  for (const glm::dvec3& p : half.positions)
    EXPECT_LT(p.z + origin.z, error + 1e-6) << "from +X by -Z to -X, counter-clockwise from above";
}

TEST(Grow, AnEndCapGoesWithTheGrowingEnd) {
  const Parsed parsed = glb(scene_text("", kArc), {.bake_size = 32, .grow_seconds = 2});
  // The two caps, of 8 corners each, come last; the end's looks along the tangent.
  const Shown shown = at_time(parsed, 1.0);
  const double angle = kPi / 2;
  const glm::dvec3 tangent(-std::sin(angle), 0, -std::cos(angle));
  std::size_t along = 0;
  for (std::size_t i = shown.normals.size() - 16; i < shown.normals.size(); ++i) {
    if (glm::dot(shown.normals[i], tangent) > std::cos(20 * kPi / 180)) ++along;
  }
  EXPECT_EQ(along, 8u);
}

TEST(Grow, PlanesStandStillAndASceneOfThemAloneIsRefused) {
  const std::string floor = R"({"name": "floor", "plane": {"size": [2, 2]}})";
  const Parsed parsed = glb(scene_text("", kRod + ", " + floor), {.bake_size = 32, .grow_seconds = 1});
  EXPECT_TRUE(parsed.primitive(0).contains("targets"));
  EXPECT_FALSE(parsed.primitive(1).contains("targets"));
  EXPECT_EQ(parsed.root["animations"][0]["channels"].size(), 1u);
  try {
    glb(scene_text("", floor), {.bake_size = 32, .grow_seconds = 1});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "nothing here is swept or revolved, so that nothing can grow");
  }
}

TEST(Grow, IsRefusedBeforeTargetsOverTwoGibibytesAreMade) {
  // 3 million vertices of 24 bytes a target: 30 of them are over.
  const std::string helix = R"({"name": "x", "tessellation": {"contour": 1000, "trajectory": 3000}, "sweep": {
      "contour": {"circle": {"radius": 0.1}}, "trajectory": {"helix": {"radius": 1, "pitch": 0.3, "turns": 5}}}})";
  try {
    glb(scene_text("", helix), {.grow_seconds = 5});
    ADD_FAILURE() << "a file was made";
  } catch (const InputError& error) {
    EXPECT_NE(error.problem().find("morph targets, which would be over 2 GiB; ask for fewer cells"),
              std::string::npos)
        << error.problem();
  }
}

TEST(Grow, IsRefusedWithVerticesThatAreQuantizedOrPacked) {
  for (const GltfOptions& options : {GltfOptions{.grow_seconds = 5, .is_quantized = true},
                                     GltfOptions{.grow_seconds = 5, .is_packed = true}}) {
    try {
      make(scene_text("", kRod), "a.glb", options);
      ADD_FAILURE() << "a file was made";
    } catch (const InputError& error) {
      EXPECT_EQ(error.problem(),
                "what grows has morph targets, which are neither quantized nor packed; leave one out");
    }
  }
}

TEST(Grow, EveryInstanceGrowsByTheSameNumbers) {
  const std::string two =
      swept(R"("contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0, 0, 0], [0, 2, 0]]})",
            R"(, "instances": [{}, {"translate": [1, 0, 0]}])");
  const Parsed parsed = glb(scene_text("", two), {.bake_size = 32, .grow_seconds = 1});
  const json& animation = parsed.root["animations"][0];
  EXPECT_EQ(animation["samplers"].size(), 1u);
  EXPECT_EQ(animation["channels"].size(), 2u);
}

}  // namespace
}  // namespace sweepkit::scene
