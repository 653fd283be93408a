// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// info tells what is in a scene, a model and an image, and tells a file from a ruin.

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Info, PrintsTheTriangleCountsOfThePapersScene) {
  const Outcome run = Workshop().sweepkit({"info", SWEEPKIT_SAMPLES "/scenes/vase_and_cup.json", "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, R"({"object": "vase", "triangles": 7200, )")) << run.out;
  EXPECT_TRUE(has(run.out, R"({"object": "cup", "triangles": 8400, )")) << run.out;
  EXPECT_TRUE(has(run.out, R"("width": 512)"));
  EXPECT_TRUE(has(run.out, R"({"texture": "tiles", "kind": "image", "width": 1024, "height": 1024, )"))
      << run.out;
}

class InfoOfAModel : public testing::TestWithParam<std::string> {};

TEST_P(InfoOfAModel, TellsWhatWasWritten) {
  const Workshop workshop;
  const std::string file = "v a s e" + GetParam();
  ASSERT_EQ(workshop.sweepkit({"generate", SWEEPKIT_SAMPLES "/scenes/vase_and_cup.json", "-o", file}).status,
            0);
  const Outcome run = workshop.sweepkit({"info", file, "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, R"({"mesh": "vase", "triangles": 7200, )")) << run.out;
  EXPECT_TRUE(has(run.out, R"({"mesh": "cup", "triangles": 8400, )")) << run.out;
  EXPECT_TRUE(has(run.out, R"({"image": "tiles", "width": 1024, "height": 1024, )")) << run.out;
  EXPECT_TRUE(has(run.out, R"({"material": "mirror", "textured": false})")) << run.out;
}

INSTANTIATE_TEST_SUITE_P(Both, InfoOfAModel, testing::Values(".glb", ".gltf"),
                         [](const auto& test) { return test.param.substr(1); });

class InfoOfAnImage : public testing::TestWithParam<std::string> {};

TEST_P(InfoOfAnImage, TellsItsSize) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const std::string file = "p." + GetParam();
  ASSERT_EQ(workshop.sweepkit({"render", "ball.json", "-o", file, "--size", "12x7"}).status, 0);
  const Outcome run = workshop.sweepkit({"info", file});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, "width: 12\nheight: 7\nchannels: 3\n")) << run.out;
  EXPECT_TRUE(has(run.out, GetParam() == "exr" ? "samples: half\n" : "samples: uint8\n")) << run.out;
}

INSTANTIATE_TEST_SUITE_P(Every, InfoOfAnImage, testing::Values("png", "jpg", "tif", "exr"),
                         [](const auto& test) { return test.param; });

// Cut anywhere, a .glb is refused with 2 and one line: no crash, no wrong count.
TEST(Info, RefusesEveryTruncatedModel) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  ASSERT_EQ(workshop.sweepkit({"generate", "ball.json", "-o", "ball.glb"}).status, 0);
  const std::string whole = workshop.read("ball.glb");
  for (std::size_t length = 0; length < whole.size(); length += length < 64 ? 1 : 509) {
    workshop.write("cut.glb", whole.substr(0, length));
    const Outcome run = workshop.sweepkit({"info", "cut.glb"});
    EXPECT_EQ(run.status, 2) << length;
    EXPECT_EQ(run.err.substr(0, 18), "sweepkit: cut.glb:") << length;
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
  }
}

TEST(Info, SaysWhichIndexOfAModelPointsNowhere) {
  const Workshop workshop;
  workshop.write(
      "bad.gltf",
      R"({"asset": {"version": "2.0"}, "meshes": [{"primitives": [{"attributes": {"POSITION": 7}}]}]})");
  const Outcome run = workshop.sweepkit({"info", "bad.gltf"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err,
            "sweepkit: bad.gltf:1:86: /meshes/0/primitives/0/attributes/POSITION: points at accessors 7, but "
            "there are "
            "0\n");
}

TEST(Info, FailsWhereItsTableCannotBeWritten) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const Outcome run = workshop.shell("sweepkit info ball.json > /dev/full");
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "sweepkit: standard output: cannot be written: No space left on device\n");
}

}  // namespace
}  // namespace sweepkit::test
