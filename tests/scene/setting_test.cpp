// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include "scene_text.hpp"

namespace sweepkit::scene {
namespace {

const std::string kScene =
    scene_text(R"("depth": 2, "lights": [{"point": [1, 2, 3]}], "materials": {"a/b": {}, "~": {}})");

TEST(Setting, ReplacesAValue) {
  EXPECT_EQ(parse(kScene, {{"/depth", "5"}}).depth, 5);
  EXPECT_EQ(std::get<PointLight>(parse(kScene, {{"/lights/0/point/1", "9"}}).lights[0]).position.y, 9);
}

TEST(Setting, AddsAKeyAndAppendsToAnArray) {
  EXPECT_EQ(parse(kScene, {{"/camera", R"({"width": 7})"}}).width, 7);
  const Document document = parse(kScene, {{"/lights/-", R"({"directional": [0, -1, 0]})"}});
  ASSERT_EQ(document.lights.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<DirectionalLight>(document.lights[1]));
}

TEST(Setting, TakesWhatIsNoJsonAsAString) {
  EXPECT_EQ(parse(kScene, {{"/objects/0/name", "my floor"}}).objects[0].name, "my floor");
  EXPECT_EQ(parse(kScene, {{"/objects/0/name", "\"quoted\""}}).objects[0].name, "quoted");
}

TEST(Setting, LaterOnesSeeWhatEarlierOnesMade) {
  EXPECT_EQ(parse(kScene, {{"/camera", "{}"}, {"/camera/width", "9"}, {"/camera/width", "11"}}).width, 11);
}

TEST(Setting, ReadsEscapesInPointers) {
  const Document document =
      parse(kScene, {{"/materials/a~1b/reflect", "0.5"}, {"/materials/~0/reflect", "0.25"}});
  EXPECT_EQ(document.materials[0].reflect, 0.5f);
  EXPECT_EQ(document.materials[1].reflect, 0.25f);
}

TEST(Setting, PointersThatLeadNowhereAreRefusedByNameOfTheOption) {
  const auto fault = [](const std::string& pointer) { return fault_of(kScene, {{pointer, "1"}}); };
  EXPECT_EQ(fault(""), "--set: a pointer begins with \"/\" (/objects/0/name), got \"\"");
  EXPECT_EQ(fault("depth"), "--set: a pointer begins with \"/\" (/objects/0/name), got \"depth\"");
  EXPECT_EQ(fault("/a~2"), "--set: in a pointer \"~\" is written ~0 and \"/\" ~1, got \"/a~2\"");
  EXPECT_EQ(fault("/a~"), "--set: in a pointer \"~\" is written ~0 and \"/\" ~1, got \"/a~\"");
  EXPECT_EQ(fault("/camera/width"),
            "--set: /camera/width: there is no \"camera\" in the scene; set that first");
  EXPECT_EQ(fault("/lights/1"),
            "--set: /lights/1: there is no entry \"1\": /lights has the entries 0 to 0; append with \"-\"");
  EXPECT_EQ(fault("/lights/00"),
            "--set: /lights/00: there is no entry \"00\": /lights has the entries 0 to 0; append with \"-\"");
  EXPECT_EQ(
      fault("/lights/-/point"),
      "--set: /lights/-/point: there is no entry \"-\": /lights has the entries 0 to 0; append with \"-\"");
  EXPECT_EQ(fault("/depth/x"), "--set: /depth/x: /depth is a number and has no \"x\"");
}

TEST(Setting, FaultsOfTheValueNameTheOption) {
  EXPECT_EQ(fault_of(kScene, {{"/depth", "many"}}), "--set: /depth: needs a number, got a string");
  EXPECT_EQ(fault_of(kScene, {{"/dept", "3"}}),
            "--set: /dept: unknown key \"dept\"; did you mean \"depth\"?");
  EXPECT_EQ(fault_of(kScene, {{"/lights/0", "{\"point\": [0, 0]}"}}),
            "--set: /lights/0/point: needs 3 numbers, got 2");
  EXPECT_EQ(fault_of(kScene, {{"/depth", "1e999"}}), "--set: /depth: needs a number, got a string");
}

}  // namespace
}  // namespace sweepkit::scene
