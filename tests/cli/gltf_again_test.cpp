// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// A glTF file made again from the scene that it keeps.

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

void expect_made(const Outcome& run) {
  EXPECT_EQ(run.status, 0) << run.err;
}

const std::string kCheckered = scene_of(
    std::string(kBall) + R"(, {"name": "floor", "material": "m", "plane": {"size": [3, 4]}})",
    R"("textures": {"t": {"procedural": "checker"}}, "materials": {"m": {"texture": "t", "transmit": 0.5}, "spare": {}})");

TEST(GltfAgain, HasTheSameBytes) {
  const Workshop workshop;
  workshop.write("s.json", kCheckered);
  const std::vector<std::vector<std::string>> variants = {
      {"--max-texture", "32"},
      {"--bake-size", "32"},
      {"--texel-density", "8.5"},
      {"--bake-size", "32", "--object", "floor", "--tangents", "--unlit"},
      {"--bake-size", "32", "--turntable", "6.5"},
      {"--bake-size", "64", "--max-texture", "16", "--compatible", "--image-format", "jpg", "--copyright",
       "© me"},
      {"--bake-size", "16", "--quantize", "--position-bits", "12", "--meshopt"},
      {"--bake-size", "16", "--lod", "3"},
      {"--bake-size", "16", "--set", "/objects/0/scale=2"}};
  for (const std::vector<std::string>& variant : variants) {
    std::vector<std::string> arguments = {"generate", "s.json", "-o", "a.glb"};
    arguments.insert(arguments.end(), variant.begin(), variant.end());
    expect_made(workshop.sweepkit(arguments));
    expect_made(workshop.sweepkit({"generate", "a.glb", "-o", "again.glb"}));
    expect_made(workshop.sweepkit({"generate", "again.glb", "-o", "third.glb"}));
    EXPECT_TRUE(workshop.read("a.glb") == workshop.read("again.glb"));
    EXPECT_TRUE(workshop.read("a.glb") == workshop.read("third.glb"));
  }
}

TEST(GltfAgain, FromAGltfAndItsFiles) {
  const Workshop workshop;
  workshop.write("s.json", kCheckered);
  expect_made(
      workshop.shell("mkdir one two && sweepkit generate s.json --bake-size 16 -o one/a.gltf && "
                     "sweepkit generate one/a.gltf -o two/a.gltf && diff -r one two"));
}

TEST(GltfAgain, OfCurvesOnTheCommandLineAndOfRows) {
  const Workshop workshop;
  expect_made(workshop.sweepkit({"generate", "--contour", "circle:0.1", "--trajectory",
                                 "helix:radius=1,pitch=0.3,turns=2", "-o", "spring.glb"}));
  expect_made(workshop.sweepkit({"generate", "spring.glb", "-o", "again.glb"}));
  EXPECT_TRUE(workshop.read("spring.glb") == workshop.read("again.glb"));

  workshop.write("s.json", scene_of(kBall));
  workshop.write("v.csv", "/objects/0/revolve/angle_deg\n90\n270\n");
  expect_made(workshop.sweepkit({"generate", "s.json", "--each", "v.csv", "-o", "row_{row}.glb"}));
  EXPECT_FALSE(workshop.read("row_1.glb") == workshop.read("row_2.glb"));
  for (const std::string name : {"row_1.glb", "row_2.glb"}) {
    expect_made(workshop.sweepkit({"generate", name, "-o", "again.glb"}));
    EXPECT_TRUE(workshop.read(name) == workshop.read("again.glb")) << name;
  }
}

TEST(GltfAgain, WithChangesIsTheSceneWithThem) {
  const Workshop workshop;
  workshop.write("s.json", kCheckered);
  expect_made(workshop.sweepkit({"generate", "s.json", "--bake-size", "32", "-o", "a.glb"}));
  expect_made(workshop.sweepkit(
      {"generate", "a.glb", "--set", "/objects/1/scale=2", "--bake-size", "16", "--unlit", "-o", "b.glb"}));
  expect_made(workshop.sweepkit(
      {"generate", "s.json", "--set", "/objects/1/scale=2", "--bake-size", "16", "--unlit", "-o", "c.glb"}));
  EXPECT_TRUE(workshop.read("b.glb") == workshop.read("c.glb"));
  for (const char* command : {"render", "check"}) {
    std::vector<std::string> arguments = {command, "a.glb"};
    if (std::string(command) == "render") arguments.insert(arguments.end(), {"-o", "p.png", "--size", "8x8"});
    expect_made(workshop.sweepkit(arguments));
  }
}

TEST(GltfAgain, FindsTheFilesThatTheSceneNamesBesideItOrWhereTold) {
  const Workshop workshop;
  expect_made(workshop.shell("mkdir -p in/curves out"));
  workshop.write("in/curves/way.csv", "0,0,0\n0,1,0\n0,2,1\n");
  workshop.write("in/s.json", scene_of(R"({"name": "x", "sweep": {"contour": {"circle": {"radius": 0.1}},
      "trajectory": {"csv": "curves/way.csv"}}})"));
  expect_made(workshop.sweepkit({"generate", "in/s.json", "-o", "out/a.glb"}));
  const Outcome lost = workshop.sweepkit({"generate", "out/a.glb", "-o", "b.glb"});
  EXPECT_EQ(lost.status, 2);
  EXPECT_NE(
      lost.err.find("no such file; --files-in tells the folder of the scene that the glTF was made from\n"),
      std::string::npos)
      << lost.err;
  expect_made(workshop.sweepkit({"generate", "out/a.glb", "--files-in", "in", "-o", "b.glb"}));
  EXPECT_TRUE(workshop.read("out/a.glb") == workshop.read("b.glb"));
  expect_made(
      workshop.shell("cp out/a.glb in/ && sweepkit generate in/a.glb -o c.glb && cmp in/a.glb c.glb"));
}

TEST(GltfAgain, IsRefusedWhereTheFileKeepsNoSceneOrThereIsNothingToLookFor) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kBall));
  expect_made(workshop.sweepkit({"generate", "s.json", "-o", "a.glb", "--no-extras"}));
  EXPECT_EQ(workshop.read("a.glb").find("extras"), std::string::npos);
  const Outcome none = workshop.sweepkit({"generate", "a.glb", "-o", "b.glb"});
  EXPECT_EQ(none.status, 2);
  EXPECT_EQ(none.err,
            "sweepkit: a.glb: does not hold the scene that it was made from; give the scene file itself\n");
  const Outcome folder = workshop.sweepkit({"generate", "s.json", "--files-in", ".", "-o", "b.glb"});
  EXPECT_EQ(folder.status, 2);
  EXPECT_EQ(
      folder.err,
      "sweepkit: --files-in: is for the scene in a .glb or .gltf; a scene file's names are relative to it\n");
}

}  // namespace
}  // namespace sweepkit::test
