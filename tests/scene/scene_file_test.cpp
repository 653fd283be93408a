// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// One scene file, parsed once, that many documents are read from.

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "scene_text.hpp"

namespace sweepkit::scene {
namespace {

const std::string kScene = scene_text(R"("depth": 2, "lights": [{"point": [1, 2, 3]}])");

Setting in_table(const std::string& pointer, const std::string& value) {
  return {
      pointer, value, {.file = "t.csv", .line = 7, .column = 5}, {.file = "t.csv", .line = 1, .column = 3}};
}

template <class Work>
std::string fault(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SceneFile, SettingsOfOneDocumentAreNotSeenByTheNext) {
  const SceneFile file(kScene, "folder/s.json");
  EXPECT_EQ(file.document(std::vector<Setting>{{"/depth", "5"}}).depth, 5);
  EXPECT_EQ(file.document().depth, 2);
  EXPECT_EQ(file.document(std::vector<Setting>{{"/lights/-", R"({"point": [0, 0, 0]})"}}).lights.size(), 2u);
  EXPECT_EQ(file.document().lights.size(), 1u);
}

TEST(SceneFile, WhatIsSetForAllComesBeforeWhatIsSetForOne) {
  SceneFile file(kScene, "folder/s.json");
  file.set({"/depth", "3"});
  file.set({"/camera", "{}"});
  EXPECT_EQ(file.document().depth, 3);
  EXPECT_EQ(file.document(std::vector<Setting>{{"/depth", "4"}, {"/camera/width", "9"}}).depth, 4);
  EXPECT_EQ(file.document(std::vector<Setting>{{"/depth", "4"}, {"/camera/width", "9"}}).width, 9);
}

TEST(SceneFile, FaultsStandWhereTheValueOrThePointerStands) {
  const SceneFile file(kScene, "s.json");
  const auto fault_of_row = [&](const std::string& pointer, const std::string& value) {
    return fault([&] { file.document(std::vector<Setting>{in_table(pointer, value)}); });
  };
  EXPECT_EQ(fault_of_row("/depth", "many"), "t.csv:7:5: /depth: needs a number, got a string");
  EXPECT_EQ(fault_of_row("/lights/0", R"({"point": [0, "x", 0]})"),
            "t.csv:7:5: /lights/0/point/1: needs a number, got a string");
  EXPECT_EQ(fault_of_row("/dept", "3"), "t.csv:1:3: /dept: unknown key \"dept\"; did you mean \"depth\"?");
  EXPECT_EQ(fault_of_row("/camera/width", "3"),
            "t.csv:1:3: /camera/width: there is no \"camera\" in the scene; set that first");
  EXPECT_EQ(fault_of_row("depth", "3"),
            "t.csv:1:3: a pointer begins with \"/\" (/objects/0/name), got \"depth\"");
}

TEST(SceneFile, ChecksAPointerWithoutSettingIt) {
  const SceneFile file(kScene, "s.json");
  const Place place{.file = "t.csv", .line = 1, .column = 3};
  file.check_pointer("/depth", place);
  file.check_pointer("/camera", place);
  file.check_pointer("/lights/-", place);
  EXPECT_EQ(
      fault([&] { file.check_pointer("/lights/1", place); }),
      "t.csv:1:3: /lights/1: there is no entry \"1\": /lights has the entries 0 to 0; append with \"-\"");
  EXPECT_EQ(file.document().depth, 2);
  EXPECT_EQ(file.document().lights.size(), 1u);
}

TEST(SceneFile, GivesDocumentsToAnyNumberOfThreadsAtOnce) {
  const SceneFile file(kScene, "s.json");
  std::vector<int> wrong(4);
  std::vector<std::thread> threads;
  threads.reserve(wrong.size());
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 200; ++i) {
        const int depth = (t * 200 + i) % 65;  // the depths there are
        const Document document = file.document(std::vector<Setting>{{"/depth", std::to_string(depth)}});
        wrong[static_cast<std::size_t>(t)] += document.depth != depth;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4));
}

}  // namespace
}  // namespace sweepkit::scene
