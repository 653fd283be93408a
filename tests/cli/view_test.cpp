// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// The page of `view` as a file; tests/viewers opens it in a browser.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

const char* const kScene = R"({"sweepkit": 1, "objects": [
  {"name": "tube", "translate": [1, 0, 0], "tessellation": {"contour": 8, "trajectory": 8},
   "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0, 0, 0], [0, 1, 0]]}}},
  {"name": "floor", "plane": {"size": [4, 4]}}]})";

class View : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(std::filesystem::path(SWEEPKIT_PROGRAM).parent_path() /
                                 "sweepkit-view.html")) {
      ASSERT_EQ(std::getenv("CI"), nullptr) << "in CI the page is bundled";
      GTEST_SKIP() << "SKIPPED: this build has no page; scripts/setup, and build again";
    }
    workshop_.write("scene.json", kScene);
  }

  // What stands between the two words.
  std::string part(const std::string& begin, const std::string& end) const {
    const std::string page = workshop_.read("page.html");
    const std::size_t from = page.find(begin) + begin.size();
    return page.substr(from, page.find(end, from) - from);
  }
  void make(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"view", "scene.json", "-o", "page.html"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = workshop_.sweepkit(arguments);
    ASSERT_EQ(run.status, 0) << run.err;
  }
  void expect_refused(const std::vector<std::string>& arguments, const std::string& message) const {
    const auto before = workshop_.contents();
    const Outcome run = workshop_.sweepkit(arguments);
    EXPECT_EQ(run.err, "sweepkit: " + message + "\n");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(workshop_.contents(), before);
  }

  Workshop workshop_;
};

std::string decoded(const std::string& base64) {
  std::string bytes;
  unsigned group = 0;
  int bits = 0;
  for (const char c : base64) {
    if (c == '=') break;
    static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    group = group << 6 | static_cast<unsigned>(kDigits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 255);
  }
  return bytes;
}

TEST_F(View, HoldsTheModelThatGenerateMakes) {
  make();
  ASSERT_EQ(workshop_.sweepkit({"generate", "scene.json", "-o", "scene.glb", "--no-extras"}).status, 0);
  EXPECT_EQ(decoded(part(R"(<script id="model" type="application/octet-stream">)", "</script>")),
            workshop_.read("scene.glb"));
  EXPECT_EQ(part("<title>", "</title>"), "scene");
}

TEST_F(View, HoldsTheCurvesInTheWorld) {
  make();
  const std::string facts = part(R"(<script id="facts" type="application/json">)", "</script>");
  EXPECT_EQ(facts.find(R"({"title": "scene", "curves": {"tube": {"origin": [1,0,0], "curves": [)"), 0u)
      << facts;
  EXPECT_NE(facts.find(R"({"kind": "trajectory", "points": [0,0,0,0,1,0]})"), std::string::npos) << facts;
  EXPECT_NE(facts.find(R"("kind": "contour")"), std::string::npos);
  EXPECT_EQ(facts.find("floor"), std::string::npos) << "a plane is made of no curves";
}

TEST_F(View, ShowsAModelAsItStands) {
  ASSERT_EQ(workshop_.sweepkit({"generate", "scene.json", "-o", "scene.glb"}).status, 0);
  const Outcome run = workshop_.sweepkit({"view", "scene.glb", "-o", "page.html", "--quiet"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(decoded(part(R"(<script id="model" type="application/octet-stream">)", "</script>")),
            workshop_.read("scene.glb"));
}

TEST_F(View, IsTheSameBytesTwiceAndOnStandardOutput) {
  make();
  const std::string page = workshop_.read("page.html");
  make({"--object", "tube"});
  EXPECT_NE(workshop_.read("page.html"), page);
  make();
  EXPECT_EQ(workshop_.read("page.html"), page);
  EXPECT_EQ(workshop_.sweepkit({"view", "scene.json", "-o", "-", "--quiet"}).out, page);
}

TEST_F(View, RefusesWhatItCannotShow) {
  expect_refused({"view", "scene.json"}, "-o PAGE.html is needed");
  expect_refused({"view", "scene.json", "-o", "page.glb"}, "page.glb: a page's name ends in .html");
  expect_refused({"view", "scene.json", "-o", "none/page.html"},
                 "none/page.html: there is no folder none; make it first");
  ASSERT_EQ(workshop_.sweepkit({"generate", "scene.json", "-o", "scene.gltf"}).status, 0);
  expect_refused(
      {"view", "scene.gltf", "-o", "page.html"},
      "scene.gltf: has its buffer and images beside it; a page holds a .glb or is made of the scene");
  ASSERT_EQ(workshop_.sweepkit({"generate", "scene.json", "-o", "scene.glb"}).status, 0);
  expect_refused({"view", "scene.glb", "-o", "page.html", "--object", "tube"},
                 "scene.glb: is shown as it stands; --set and --object are for scenes");
  workshop_.write("cut.glb", workshop_.read("scene.glb").substr(0, 100));
  expect_refused({"view", "cut.glb", "-o", "page.html"},
                 "cut.glb: is cut short: it should have " +
                     std::to_string(workshop_.read("scene.glb").size()) + " bytes, got 100");
  expect_refused({"view", "scene.json", "-o", "page.html", "--object", "chair"},
                 "--object: there is no object \"chair\"; there is \"tube\", \"floor\"");
}

}  // namespace
}  // namespace sweepkit::test
