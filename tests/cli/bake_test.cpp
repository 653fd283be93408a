// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Textures and normal maps made by bake, and their sizes.

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

class BakeTest : public testing::Test {
 protected:
  BakeTest() {
    workshop.write(
        "s.json",
        scene_of(R"({"name": "wall", "material": "m", "plane": {"size": [2, 1]}},
                               {"name": "stone", "material": "n", "plane": {"size": [2, 1]}})",
                 R"("textures": {"t": {"procedural": "tiles", "scale": 4}, "n": {"procedural": "marble"}},
                               "materials": {"m": {"texture": "t"}, "n": {"texture": "n"}})"));
  }
  Outcome bake(std::vector<std::string> more, const std::string& object = "wall") const {
    std::vector<std::string> arguments = {"bake", "s.json", "--object", object, "-o", "a.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return workshop.sweepkit(arguments);
  }
  const Workshop workshop;
};

TEST_F(BakeTest, FollowsTheObjectUnlessToldItsSizeOrDensity) {
  EXPECT_NE(bake({}).err.find("a.png: 1024 x 512 texels"), std::string::npos);
  EXPECT_NE(bake({"--texel-density", "100"}).err.find("a.png: 200 x 100 texels"), std::string::npos);
  EXPECT_NE(bake({"--size", "30x40"}).err.find("a.png: 30 x 40 texels"), std::string::npos);
}

// The wall's texture repeats, the stone's is laid out over it.
TEST_F(BakeTest, AnyNumberOfThreadsMakesTheSameBytes) {
  for (const std::string object : {"wall", "stone"}) {
    ASSERT_EQ(bake({"--size", "60x40", "--threads", "1"}, object).status, 0);
    const std::string alone = workshop.read("a.png");
    ASSERT_EQ(bake({"--size", "60x40", "--threads", "3"}, object).status, 0);
    EXPECT_EQ(workshop.read("a.png"), alone);
  }
  const auto made = [&](const std::string& file, const char* threads) {
    const Outcome run =
        workshop.sweepkit({"generate", "s.json", "--bake-size", "64", "--threads", threads, "-o", file});
    EXPECT_EQ(run.status, 0) << run.err;
    return workshop.contents();
  };
  for (const std::string file : {"a.glb", "a.obj"}) EXPECT_EQ(made(file, "1"), made(file, "3"));
}

TEST_F(BakeTest, ANormalMapOfItsOwnMakingIsOneThatAMaterialTakes) {
  ASSERT_EQ(bake({"--texel-density", "32", "--normals", "0.01"}).status, 0);
  workshop.write(
      "lit.json",
      scene_of(R"({"name": "wall", "material": "m", "plane": {"size": [2, 1]}})",
               R"("textures": {"t": {"image": "a.png"}}, "materials": {"m": {"normal_map": "t"}})"));
  const Outcome render =
      workshop.sweepkit({"render", "lit.json", "-o", "p.png", "--size", "16x16", "--explain"});
  EXPECT_EQ(render.status, 0) << render.err;
  EXPECT_NE(render.out.find("normal maps         yes"), std::string::npos) << render.out;
}

TEST_F(BakeTest, RefusesWhatItCannotDo) {
  EXPECT_EQ(
      bake({"--normals", "0.01"}, "stone").err,
      "sweepkit: --normals: needs a texture that repeats with (u,v), an image or a procedural one on (u,v) "
      "with a whole scale; this one is laid out over the object\n");
  EXPECT_EQ(bake({"--texel-density", "100", "--size", "8x8"}).status, 2);
  EXPECT_EQ(bake({"--texel-density", "0"}).status, 2);
  EXPECT_EQ(bake({"--normals", "1e7"}).status, 2);
  EXPECT_EQ(bake({"--threads", "0"}).status, 2);
}

TEST_F(BakeTest, GenerateTakesADensityForMeshFilesToo) {
  EXPECT_EQ(workshop.sweepkit({"generate", "s.json", "--texel-density", "20", "-o", "a.obj"}).status, 0);
  EXPECT_EQ(
      workshop.sweepkit({"generate", "s.json", "--texel-density", "20", "--bake-size", "8", "-o", "a.obj"})
          .status,
      2);
  EXPECT_EQ(workshop.sweepkit({"generate", "s.json", "--texel-density", "20", "-o", "a.stl"}).err,
            "sweepkit: --texel-density: is for .glb, .gltf and .obj: other formats hold no textures\n");
}

}  // namespace
}  // namespace sweepkit::test
