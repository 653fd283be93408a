// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// --explain shows what a scene needs, and the counters beside it that what was left out cost nothing.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

struct Part {
  std::string needed, bytes, calls;
};

// The table of --explain --json by its parts' names. Not a JSON reader: one row a line is part of what it
// promises.
std::map<std::string, Part> parts_of(const std::string& json) {
  const auto field = [](const std::string& line, const std::string& name) {
    const std::size_t at = line.find("\"" + name + "\": ");
    if (at == std::string::npos) return std::string();
    const std::size_t start = at + name.size() + 4;
    const bool is_text = line[start] == '"';
    return line.substr(start + (is_text ? 1 : 0),
                       line.find_first_of(is_text ? "\"" : ",}", start + 1) - start - (is_text ? 1 : 0));
  };
  std::map<std::string, Part> parts;
  std::istringstream lines(json);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("\"part\"") == std::string::npos) continue;
    parts[field(line, "part")] = {field(line, "needed"), field(line, "bytes"), field(line, "calls")};
    EXPECT_NE(field(line, "why"), "") << line;
  }
  return parts;
}

void expect_left_out(const std::map<std::string, Part>& parts, const std::string& name) {
  ASSERT_EQ(parts.count(name), 1u) << name;
  EXPECT_EQ(parts.at(name).needed, "false") << name;
  EXPECT_EQ(parts.at(name).bytes, "0") << name;
  EXPECT_EQ(parts.at(name).calls, "0") << name;
}

TEST(Explain, OfAPlainSceneShowsTexturesTablesRowsAndTreesLeftOutAtNoCost) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall, R"("camera": {"width": 64, "height": 64})"));
  const Outcome run = workshop.sweepkit(
      {"render", "ball.json", "-o", "ball.png", "--shadows", "hard", "--explain", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto parts = parts_of(run.out);
  for (const char* name :
       {"half-edges",        "(u,v) layouts",      "textures",      "baked textures",  "glass thicknesses",
        "integral tables",   "texture tiles",      "(u,v) at hits", "filtered nodes",  "ray differentials",
        "row buffers",       "intersection trees", "refractions",   "shares by angle", "dimmed shadows",
        "shadow edges",      "background image",   "supersampling", "refinement",      "layers",
        "tree over objects", "normal maps",        "error estimate"}) {
    expect_left_out(parts, name);
  }
  EXPECT_EQ(parts.at("shadow rays").needed, "true");
}

TEST(Explain, OfAGenerateShowsThatNoPictureIsDrawn) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const Outcome run = workshop.sweepkit({"generate", "ball.json", "-o", "ball.glb", "--explain", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  for (const auto& [name, part] : parts_of(run.out)) expect_left_out(parts_of(run.out), name);
}

TEST(Explain, OfASceneThatNeedsNearlyEverythingCountsAllButWhatGlassTablesAndRefinementNeed) {
  const Workshop workshop;
  const Outcome run =
      workshop.sweepkit({"render", SWEEPKIT_SAMPLES "/scenes/vase_and_cup.json", "-o", "p.png", "--explain",
                         "--json", "--size", "48x48", "--antialias", "3x3", "--aov", "depth"});
  ASSERT_EQ(run.status, 0) << run.err;
  for (const auto& [name, part] : parts_of(run.out)) {
    if (name == "half-edges" || name == "(u,v) layouts" || name == "baked textures" ||
        name == "glass thicknesses" || name == "integral tables" || name == "refractions" ||
        name == "shares by angle" || name == "dimmed shadows" || name == "background image" ||
        name == "refinement" || name == "normal maps" || name == "error estimate") {
      expect_left_out(parts_of(run.out), name);
    } else {
      EXPECT_EQ(part.needed, "true") << name;
      EXPECT_NE(part.calls, "0") << name;
    }
  }
}

TEST(Explain, WithoutAnOutputPrintsThePlanAndDoesNoWork) {
  const Workshop workshop;
  // The texture is not there: work would find that out.
  workshop.write(
      "scene.json",
      scene_of(R"({"name": "x", "material": "m", "plane": {"size": [1, 1]}})",
               R"("textures": {"t": {"image": "none.png"}}, "materials": {"m": {"texture": "t"}})"));
  const auto before = workshop.contents();
  for (const char* command : {"generate", "render"}) {
    const Outcome run = workshop.sweepkit({command, "scene.json", "--explain"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("textures            yes     materials in use have textures\n"), std::string::npos)
        << run.out;
    EXPECT_EQ(run.err, "");
  }
  EXPECT_EQ(workshop.contents(), before);
}

TEST(Explain, MakesWayForAResultOnStandardOutput) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const Outcome run = workshop.sweepkit({"generate", "ball.json", "-o", "-", "--explain", "--quiet"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out.substr(0, 4), "glTF");
  EXPECT_EQ(run.err.substr(0, 4), "part");
}

TEST(Quiet, SaysNothing) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const Outcome loud = workshop.sweepkit({"generate", "ball.json", "-o", "ball.glb"});
  EXPECT_EQ(loud.err.substr(0, 34), "ball.glb: 1 object, 720 triangles,");
  EXPECT_EQ(loud.out, "");
  const Outcome quiet = workshop.sweepkit({"generate", "ball.json", "-o", "ball.glb", "--quiet"});
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST(Statistics, AreWrittenBesideThePicture) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const Outcome run = workshop.sweepkit(
      {"render", "ball.json", "-o", "p.png", "--size", "20x10", "--shadows", "hard", "--stats", "p.json"});
  EXPECT_EQ(run.status, 0) << run.err;
  // For the error's estimate pixels are compared with their neighbours, those of a border too: 22 x 12.
  EXPECT_NE(workshop.read("p.json").find("\"eye_rays\": 264,"), std::string::npos) << workshop.read("p.json");
  const auto names_of = [](const std::map<std::string, Part>& parts) {
    std::vector<std::string> names;
    for (const auto& [name, part] : parts) names.push_back(name);
    return names;
  };
  const Outcome plan = workshop.sweepkit({"render", "ball.json", "--explain", "--json"});
  EXPECT_EQ(names_of(parts_of(workshop.read("p.json"))), names_of(parts_of(plan.out)));
}

TEST(Statistics, HaveAPageThatTellsEveryKeyAndAPhaseForEverySecond) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const Outcome run = workshop.sweepkit({"render", "ball.json", "-o", "p.png", "--size", "20x10", "--stats",
                                         "p.json", "--aov", "depth", "--antialias", "3x3"});
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string statistics = workshop.read("p.json");
  EXPECT_NE(statistics.find("\"layer_rays\": 200,"), std::string::npos) << statistics;
  std::ifstream file(SWEEPKIT_SAMPLES "/../docs/rendering.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  int keys = 0;
  std::istringstream lines(statistics);
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, 3, "  \"") != 0) continue;
    const std::string key = line.substr(3, line.find('"', 3) - 3);
    EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
    ++keys;
  }
  EXPECT_GT(keys, 15);
  for (const char* phase :
       {"reading", "meshes", "textures", "accelerators", "picture", "encoding", "writing"}) {
    EXPECT_NE(statistics.find(std::string("{\"phase\": \"") + phase + "\", \"seconds\": "), std::string::npos)
        << phase;
  }
}

TEST(Statistics, OfFramesAreAddedUp) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const Outcome run = workshop.sweepkit({"render", "ball.json", "-o", "p{frame}.png", "--size", "20x10",
                                         "--stats", "p.json", "--frames", "1-3", "--shadows", "hard"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(workshop.read("p.json").find("\"pictures\": 3,\n  \"eye_rays\": 792,"), std::string::npos)
      << workshop.read("p.json");
}

TEST(Object, AloneNeedsNothingOfTheOthers) {
  const Workshop workshop;
  workshop.write(
      "scene.json",
      scene_of(std::string(kBall) + R"(,
 {"name": "x", "material": "m", "plane": {"size": [1, 1]}})",
               R"("textures": {"t": {"image": "none.png"}}, "materials": {"m": {"texture": "t"}})"));
  // The other object's texture is not there, and nobody looks.
  const Outcome run = workshop.sweepkit({"generate", "scene.json", "-o", "ball.glb", "--object", "ball"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err.substr(0, 34), "ball.glb: 1 object, 720 triangles,");
}

}  // namespace
}  // namespace sweepkit::test
