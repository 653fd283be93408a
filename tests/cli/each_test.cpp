// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// generate --each: a file for each row of a table, the same bytes as one run of generate --set for each.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

// A tube that reads its values, textured by an image and by a procedural that repeats.
const std::string kTube =
    scene_of(R"({"name": "tube", "material": "banded", "tessellation": {"contour": 12, "trajectory": 8},
  "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0, 0, 0], [0, 1, 0]]}, "twist_deg": 10}})",
             R"( "textures": {"bands": {"image": ")" SWEEPKIT_SAMPLES R"(/textures/vase_bands.png"},
               "checks": {"procedural": "checker", "scale": 4}},
 "materials": {"banded": {"texture": "bands"}, "checked": {"texture": "checks"}})");

using Arguments = std::vector<std::string>;

Outcome generate_each(const Workshop& workshop, const std::string& pattern, const Arguments& more = {}) {
  Arguments arguments = {"generate", "scene.json", "--each",      "values.csv",
                         "-o",       pattern,      "--bake-size", "16"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return workshop.sweepkit(arguments);
}

// What a run has added, by name.
std::map<std::string, std::string> made(const Workshop& workshop) {
  std::map<std::string, std::string> files = workshop.contents();
  files.erase("scene.json");
  files.erase("values.csv");
  return files;
}

TEST(Each, GivesTheBytesOfSingleRunsForEveryFormatAndNumberOfThreads) {
  const std::vector<Arguments> rows = {
      {"/objects/0/sweep/twist_deg=90", "/objects/0/name=a b", "/objects/0/translate=[1,2,3]"},
      {"/objects/0/material=checked", "/objects/0/name=1"},
      {},
      {"/objects/0/sweep/twist_deg={\"points\": [[0, 0], [1, 45]]}", "/objects/0/name=d"}};
  const std::string table =
      "/objects/0/sweep/twist_deg,/objects/0/name,/objects/0/translate,/objects/0/material\r\n"
      "90,a b,\"[1,2,3]\",\r\n"
      ",\"\"\"1\"\"\",,checked\r\n"
      ",,,\r\n"
      "\"{\"\"points\"\": [[0, 0], [1, 45]]}\",d,,\r\n";
  for (const std::string extension : {".glb", ".gltf"}) {
    const Workshop singles;
    singles.write("scene.json", kTube);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Arguments arguments = {"generate",    "scene.json",
                             "--bake-size", "16",
                             "-o",          "out" + std::to_string(i + 1) + extension,
                             "--set",       "/objects/0/crease_deg=20"};
      for (const std::string& setting : rows[i]) {
        // As JSON: --set would take the bare 1 for a number, the table's quotes say that it is a string.
        arguments.insert(arguments.end(),
                         {"--set", setting == "/objects/0/name=1" ? "/objects/0/name=\"1\"" : setting});
      }
      const Outcome run = singles.sweepkit(arguments);
      ASSERT_EQ(run.status, 0) << run.err;
    }
    const auto expected = made(singles);
    EXPECT_EQ(expected.size(), extension == ".glb" ? 4u : 12u) << "with a buffer and an image each";

    for (const char* threads : {"1", "2", "7"}) {
      const Workshop workshop;
      workshop.write("scene.json", kTube);
      workshop.write("values.csv", table);
      const Outcome run = generate_each(workshop, "out{row}" + extension,
                                        {"--threads", threads, "--set", "/objects/0/crease_deg=20"});
      EXPECT_EQ(run.status, 0) << run.err;
      EXPECT_EQ(run.err.substr(0, run.err.find(',')), "values.csv: 4 rows made");
      EXPECT_EQ(made(workshop), expected) << extension << ", " << threads << " threads";
    }
  }
}

TEST(Each, ValuesComeAfterSettings) {
  const Workshop workshop;
  workshop.write("scene.json", kTube);
  workshop.write("values.csv", "/objects/0/name,/depth\nrow,1\n,2\n");
  ASSERT_EQ(generate_each(workshop, "{row}.glb", {"--set", "/objects/0/name=option"}).status, 0);
  EXPECT_NE(workshop.read("1.glb").find(R"("name":"row")"), std::string::npos);
  EXPECT_NE(workshop.read("2.glb").find(R"("name":"option")"), std::string::npos)
      << "an empty cell leaves what the scene has";
}

TEST(Each, RowNumbersHaveTheTablesWidthSoThatNamesSort) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  std::string table = "/objects/0/scale\n";
  for (int i = 1; i <= 12; ++i) table += std::to_string(i) + '\n';
  workshop.write("values.csv", table);
  ASSERT_EQ(generate_each(workshop, "ball_{row}.glb").status, 0);
  const auto files = made(workshop);
  EXPECT_EQ(files.size(), 12u);
  EXPECT_EQ(files.begin()->first, "ball_01.glb");
  EXPECT_EQ(files.rbegin()->first, "ball_12.glb");
}

TEST(Each, NamesFilesForAColumnsValues) {
  const Workshop workshop;
  std::filesystem::create_directory(workshop.folder() / "blue");
  workshop.write("scene.json", scene_of(kBall));
  workshop.write("values.csv", "/objects/0/name,/objects/0/scale\nblue,2\n\"\"\"blue\"\"\",0.5\n");
  ASSERT_EQ(generate_each(workshop, "{/objects/0/name}/x{/objects/0/scale}_{row}.glb").status, 0);
  EXPECT_EQ(made(workshop).count("blue/x2_1.glb"), 1u);
  EXPECT_EQ(made(workshop).count("blue/x0.5_2.glb"), 1u) << "a JSON string's quotes are no part of it";
}

TEST(Each, OneRowNeedsNoPattern) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  workshop.write("values.csv", "/objects/0/scale\n2\n");
  EXPECT_EQ(generate_each(workshop, "ball.glb").status, 0);
  EXPECT_EQ(made(workshop).size(), 1u);
}

TEST(Each, TellsTheSameOfBadRowsForAnyNumberOfThreadsAndMakesTheOthers) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  // Bad: a value, the geometry, a name; and one row that is slower than those after it.
  workshop.write("values.csv",
                 "/objects/0/scale,/objects/0/tessellation,/objects/0/revolve/contour,/objects/0/name\n"
                 "1,\"{\"\"contour\"\": 400, \"\"trajectory\"\": 400}\",,slow\n"
                 "big,,,b\n"
                 "1,,,c\n"
                 "1,,\"{\"\"polyline\"\": [[-1, 0], [1, 1]]}\",d\n"
                 "1,\"{\"\"contour\"\":\n 0}\",,e\n"
                 "1,,,f/g\n"
                 "1,,,h\n");
  for (const char* threads : {"1", "2"}) {
    const Outcome run = generate_each(workshop, "{/objects/0/name}.glb", {"--threads", threads, "--quiet"});
    EXPECT_EQ(
        run.err,
        "sweepkit: values.csv:3:1: /objects/0/scale: needs 3 numbers in an array, got a string\n"
        "sweepkit: values.csv:5:1: scene.json:4:14: /objects/0/revolve: contour crosses the axis: x is -1 m "
        "at "
        "height 0 m; keep x, the distance from it, at 0 or above\n"
        "sweepkit: values.csv:6:3: /objects/0/tessellation/contour: needs to be at least 1 and at most 32768 "
        "cells, got 0\n"
        "sweepkit: values.csv:8:5: /objects/0/name: cannot be part of a file's name: \"f/g\"; name files by "
        "{row}\n"
        "sweepkit: values.csv: 3 rows made, 4 refused\n");
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.status, 2);
    const auto files = made(workshop);
    EXPECT_EQ(files.size(), 3u);
    for (const char* name : {"slow.glb", "c.glb", "h.glb"}) {
      EXPECT_EQ(files.count(name), 1u) << name;
      std::filesystem::remove(workshop.folder() / name);
    }
  }
}

TEST(Each, ARowThatMakesNoWayForALaterColumnNamesItsOwnLine) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  workshop.write("values.csv", "/camera,/camera/width\n{},9\n,9\n");
  const Outcome run = generate_each(workshop, "{row}.glb");
  EXPECT_EQ(
      run.err,
      "sweepkit: values.csv:3:1: values.csv:1:9: /camera/width: there is no \"camera\" in the scene; set "
      "that first\n"
      "sweepkit: values.csv: 1 row made, 1 refused\n");
  EXPECT_EQ(run.status, 2);
}

TEST(Each, JsonIsATableOfTheRows) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  workshop.write("values.csv", "/objects/0/scale\n2\nbig\n");
  const Outcome run = generate_each(workshop, "{row}.glb", {"--json", "--quiet"});
  EXPECT_EQ(run.status, 2);
  const std::string bytes = std::to_string(workshop.read("1.glb").size());
  EXPECT_EQ(run.out, R"({
  "rows": 2,
  "made": 1,
  "refused": 1,
  "table": [
    {"row": 1, "line": 2, "file": "1.glb", "made": true, "triangles": 720, "bytes": )" +
                         bytes + R"(, "problem": null},
    {"row": 2, "line": 3, "file": "2.glb", "made": false, "triangles": 0, "bytes": 0, "problem": "values.csv:3:1: /objects/0/scale: needs 3 numbers in an array, got a string"}
  ]
}
)");
}

TEST(Each, ExplainTellsWhatAnyRowNeedsAndThatSharedImagesAreReadOnce) {
  const Workshop workshop;
  workshop.write("scene.json", kTube);
  workshop.write("values.csv", "/objects/0/material,/objects/0/scale\n,1\n,2\n,3\nchecked,4\nchecked,5\n");
  const Outcome plan = generate_each(workshop, "{row}.glb", {"--explain"});
  ASSERT_EQ(plan.status, 0) << plan.err;
  // Calls: the image once, the procedural set up twice and baked once.
  EXPECT_NE(plan.out.find("textures            yes     materials in use have textures"), std::string::npos);
  const auto calls = [&](const std::string& part) {
    const std::size_t line = plan.out.find('\n' + part);
    const std::string text = plan.out.substr(line + 1, plan.out.find('\n', line + 1) - line - 1);
    return text.substr(text.rfind(' ') + 1);
  };
  EXPECT_EQ(calls("textures "), "3") << plan.out;
  EXPECT_EQ(calls("baked textures "), "1") << plan.out;
  EXPECT_EQ(calls("half-edges "), "0") << plan.out;
}

TEST(Each, ExplainWithoutAnOutputReadsEveryRowAndMakesNothing) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  workshop.write("values.csv", "/objects/0/scale\n2\nbig\n");
  const auto before = workshop.contents();
  const Outcome run = workshop.sweepkit({"generate", "scene.json", "--each", "values.csv", "--explain"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err,
            "sweepkit: values.csv:3:1: /objects/0/scale: needs 3 numbers in an array, got a string\n"
            "sweepkit: values.csv: 1 row read, 1 refused\n");
  EXPECT_EQ(run.out.substr(0, 4), "part");
  EXPECT_EQ(workshop.contents(), before);
}

TEST(Each, OfOneObjectLeavesTheOthersOut) {
  const Workshop workshop;
  workshop.write("scene.json",
                 scene_of(std::string(kBall) + R"(, {"name": "x", "plane": {"size": [1, 1]}})"));
  workshop.write("values.csv", "/objects/0/scale\n2\n3\n");
  const Outcome run = generate_each(workshop, "{row}.glb", {"--object", "x"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err.substr(0, 37), "values.csv: 2 rows made, 4 triangles,");
}

TEST(Each, AFullDiskStopsTheWork) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  workshop.write("values.csv", "/objects/0/name\na\nb\nc\n");
  std::filesystem::create_symlink("/dev/full", workshop.folder() / "b.glb");
  const Outcome run = generate_each(workshop, "{/objects/0/name}.glb", {"--threads", "1"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "sweepkit: b.glb: cannot be written: No space left on device\n");
  std::filesystem::remove(workshop.folder() / "b.glb");
  for (const auto& [name, bytes] : made(workshop)) {
    EXPECT_TRUE(name == "a.glb" || name == "c.glb") << "left behind: " << name;
  }
}

// A short piece of work on several threads, and a signal in every part of it.
TEST(Each, InterruptedAtAnyMomentLeavesWholeFilesOnly) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  std::string table = "/objects/0/scale\n";
  for (int i = 1; i <= 60; ++i) table += std::to_string(i) + '\n';
  workshop.write("values.csv", table);
  const Arguments arguments = {"generate", "scene.json", "--each",    "values.csv",
                               "-o",       "{row}.gltf", "--threads", "4"};
  const Outcome run = workshop.sweepkit(arguments);
  ASSERT_EQ(run.status, 0) << run.err;
  const auto whole = workshop.contents();
  // As long as a run takes here: a sanitizer's takes many times an optimized one's.
  constexpr int kMoments = 100;
  const double between = 1e6 * run.time.count() / kMoments;
  int in_the_middle = 0;
  for (int i = 0; i < kMoments; ++i) {
    const auto moment = static_cast<useconds_t>(i * between);
    for (const auto& [name, bytes] : made(workshop)) std::filesystem::remove(workshop.folder() / name);
    const pid_t child = workshop.start(arguments);
    usleep(moment);
    kill(child, SIGINT);
    int wait_status = 0;
    waitpid(child, &wait_status, 0);
    const int status = exit_status(wait_status);
    EXPECT_TRUE(status == 130 || status == 0) << status;
    const auto left = workshop.contents();
    for (const auto& [name, bytes] : left) {
      ASSERT_EQ(whole.count(name), 1u) << "left behind after " << moment << " us: " << name;
      EXPECT_EQ(bytes, whole.at(name)) << name << " after " << moment << " us";
      if (name.find(".bin") == std::string::npos) continue;
      // A file and what stands beside it come to the disk together.
      EXPECT_EQ(left.count(name.substr(0, name.size() - 4) + ".gltf"), 1u)
          << name << " after " << moment << " us";
    }
    in_the_middle += left.size() > 2 && left.size() < whole.size();
  }
  EXPECT_GT(in_the_middle, 0) << "no signal came while files were being written";
}

}  // namespace
}  // namespace sweepkit::test
