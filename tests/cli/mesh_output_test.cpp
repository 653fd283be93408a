// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Mesh files out: by every way of the command, and what another program makes of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

constexpr const char* kLook =
    R"("textures": {"m": {"procedural": "marble"}}, "materials": {"m": {"texture": "m"}})";

std::string marble_ball() {
  std::string ball = kBall;
  return ball.insert(1, R"("material": "m", )");
}

std::vector<std::string> names_in(const Workshop& workshop) {
  std::vector<std::string> names;
  for (const auto& [name, digest] : workshop.contents()) names.push_back(name);
  return names;
}

TEST(MeshFilesOut, EachFormatIsWrittenWithWhatBelongsToIt) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(marble_ball(), kLook));
  for (const std::string file : {"b.obj", "b.ply", "b.stl", "b.off"}) {
    const Outcome run = workshop.sweepkit({"generate", "s.json", "--bake-size", "16", "-o", file});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find(file + ": 1 object, 720 triangles, "), std::string::npos) << run.err;
    EXPECT_NE(workshop.sweepkit({"info", file}).out.find("triangles: 720"), std::string::npos) << file;
  }
  EXPECT_EQ(names_in(workshop),
            (std::vector<std::string>{"b.mtl", "b.obj", "b.off", "b.ply", "b.stl", "b_0.png", "s.json"}));
}

TEST(MeshFilesOut, WhatWasWrittenIsAnObjectAgain) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kBall));
  ASSERT_EQ(workshop.sweepkit({"generate", "s.json", "-o", "b.obj"}).status, 0);
  workshop.write("t.json", scene_of(R"({"name": "again", "mesh": {"file": "b.obj"}})"));
  ASSERT_EQ(workshop.sweepkit({"generate", "t.json", "-o", "c.obj"}).status, 0);
  workshop.write("u.json", scene_of(R"({"name": "again", "mesh": {"file": "c.obj"}})"));
  ASSERT_EQ(workshop.sweepkit({"generate", "u.json", "-o", "d.obj"}).status, 0);
  EXPECT_EQ(workshop.read("c.obj"), workshop.read("d.obj")) << "from then on the same bytes";
}

TEST(MeshFilesOut, ManyAreWrittenFromATable) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(marble_ball(), kLook));
  workshop.write("v.csv", "/objects/0/name,/objects/0/scale\none,1\ntwo,2\n");
  const Outcome run = workshop.sweepkit({"generate", "s.json", "--each", "v.csv", "-o",
                                         "{/objects/0/name}.obj", "--quiet", "--bake-size", "16"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(names_in(workshop), (std::vector<std::string>{"one.mtl", "one.obj", "one_0.png", "s.json",
                                                          "two.mtl", "two.obj", "two_0.png", "v.csv"}));
}

TEST(MeshFilesOut, AFileThatCannotBeWrittenLeavesNothingBehind) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(marble_ball(), kLook));
  const auto before = workshop.contents();
  // 8 KiB: the image and the library fit, the mesh does not.
  for (const std::string file : {"b.obj", "b.ply", "b.stl", "b.off"}) {
    const Outcome run = workshop.shell("ulimit -f 8; sweepkit generate s.json --bake-size 16 -o " + file);
    EXPECT_EQ(run.status, 1) << file << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(workshop.contents(), before) << file;
  }
}

TEST(MeshFilesOut, APlanWithoutTexturesLeavesThemOut) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(marble_ball(), kLook));
  const Outcome run = workshop.sweepkit({"generate", "s.json", "-o", "b.stl", "--explain"});
  EXPECT_NE(run.out.find("the file cannot hold textures"), std::string::npos) << run.out;
}

TEST(MeshFilesOut, TangentsAreRefusedWhereNoFormatHasThem) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kBall));
  const Outcome run = workshop.sweepkit({"generate", "s.json", "-o", "b.obj", "--tangents"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "sweepkit: --tangents: is for .glb and .gltf: other formats hold no tangents\n");
}

// assimp (scripts/setup --peers) counts and measures what it reads.
TEST(MeshFilesOut, AssimpReadsThemAll) {
  if (std::system("command -v assimp >/dev/null") != 0) GTEST_SKIP() << "assimp is not installed";
  const Workshop workshop;
  workshop.write("s.json",
                 scene_of(marble_ball() + ",\n" +
                              R"({"name": "floor", "plane": {"size": [8, 4]}, "translate": [0, -1, 0],
        "instances": [{}, {"translate": [0, 4, 0]}]})",
                          kLook));
  for (const std::string file : {"ein Gefäß.obj", "b.ply", "b.stl", "b.off"}) {
    ASSERT_EQ(workshop.sweepkit({"generate", "s.json", "--bake-size", "16", "-o", file}).status, 0);
    const Outcome run = workshop.shell("assimp info '" + file + "'");
    EXPECT_EQ(run.status, 0) << file << run.out << run.err;
    EXPECT_NE(run.out.find("Faces:              724"), std::string::npos) << file << run.out;
    EXPECT_NE(run.out.find("Minimum point      (-4.000000 -1.000000 -2.000000)"), std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("Maximum point      (4.000000 3.000000 2.000000)"), std::string::npos) << run.out;
    if (file.ends_with(".obj")) {
      EXPECT_NE(run.out.find("Meshes:             3"), std::string::npos) << run.out;
      EXPECT_NE(run.out.find("ein_Gefäß_0.png"), std::string::npos) << run.out;
    }
  }
}

}  // namespace
}  // namespace sweepkit::test
