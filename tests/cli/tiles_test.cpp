// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Tiles put together are the file that one render writes, bit for bit; what does not fit is refused.

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

using Arguments = std::vector<std::string>;

// Filtered, mirrored and with a rim of background: what a cut could change.
const char* const kScene = R"({
  "sweepkit": 1,
  "camera": {"eye": [3, 2, 4], "target": [0, 0, 0], "width": 61, "height": 47},
  "background": [0.2, 0.3, 0.4],
  "textures": {"tiles": {"image": ")" SWEEPKIT_SAMPLES R"(/textures/floor_tiles.png"}},
  "materials": {"floor": {"texture": "tiles", "reflect": 0.3}},
  "objects": [
    {"name": "floor", "material": "floor", "plane": {"size": [4, 4]}, "uv": {"repeat": [8, 8]}, "translate": [0, -1, 0]},
    {"name": "ring", "tessellation": {"contour": 16, "trajectory": 32},
     "sweep": {"contour": {"circle": {"radius": 0.2}}, "trajectory": {"circle": {"radius": 1}}}}
  ]
})";

struct Way {
  std::string name;
  std::string extension;
  Arguments options;
};

void PrintTo(const Way& way, std::ostream* stream) {
  *stream << way.name;
}

class Tiles : public testing::TestWithParam<Way> {
 protected:
  void SetUp() override { workshop_.write("scene.json", kScene); }

  void draw(const std::string& file, const Arguments& more) const {
    Arguments arguments = {"render", "scene.json", "-o", file};
    arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = workshop_.sweepkit(arguments);
    ASSERT_EQ(run.status, 0) << run.err;
  }

  Workshop workshop_;
};

TEST_P(Tiles, PutTogetherAreTheWholePictureBitForBit) {
  const std::string& extension = GetParam().extension;
  draw("whole" + extension, {});
  for (const int count : {1, 3}) {
    Arguments assemble = {"assemble", "-o", "assembled" + extension};
    // In no order, each with other threads.
    for (int i = count; i >= 1; --i) {
      const std::string file = "tile_" + std::to_string(i) + extension;
      draw(file, {"--tile", std::to_string(i) + "/" + std::to_string(count), "--threads",
                  std::to_string(1 + i % 3)});
      assemble.push_back(file);
    }
    const Outcome run = workshop_.sweepkit(assemble);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(workshop_.read("assembled" + extension), workshop_.read("whole" + extension))
        << count << " tiles";
  }
}

INSTANTIATE_TEST_SUITE_P(
    OfEveryFormat, Tiles,
    testing::Values(Way{"png", ".png", {}}, Way{"png_16", ".png", {"--bits", "16", "--exposure", "0.5"}},
                    Way{"png_alpha", ".png", {"--alpha", "--antialias", "3x3"}}, Way{"tif", ".tif", {}},
                    Way{"tif_16_alpha", ".tif", {"--bits", "16", "--alpha"}}, Way{"exr", ".exr", {}},
                    Way{"exr_32", ".exr", {"--bits", "32", "--alpha"}},
                    Way{"exr_layers",
                        ".exr",
                        {"--antialias", "3x3", "--aov", "depth,normal,uv,object-id,footprint,rays"}},
                    Way{"exr_crop", ".exr", {"--crop", "10,0,50,47"}},
                    Way{"png_marked", ".png", {"--skip-existing"}}),
    [](const auto& test) { return test.param.name; });

class Assemble : public testing::Test {
 protected:
  void SetUp() override {
    workshop_.write("scene.json", kScene);
    draw("t1.png", "1/3", {});
    draw("t2.png", "2/3", {});
    draw("t3.png", "3/3", {});
  }
  void draw(const std::string& file, const std::string& tile, const Arguments& more) const {
    Arguments arguments = {"render", "scene.json", "-o", file, "--tile", tile};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = workshop_.sweepkit(arguments);
    ASSERT_EQ(run.status, 0) << run.err;
  }
  // The one line that it is refused with; nothing is written.
  std::string refusal(const Arguments& tiles, const std::string& output = "out.png") const {
    const auto before = workshop_.contents();
    Arguments arguments = {"assemble", "-o", output};
    arguments.insert(arguments.end(), tiles.begin(), tiles.end());
    const Outcome run = workshop_.sweepkit(arguments);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(workshop_.contents(), before);
    return run.err;
  }

  Workshop workshop_;
};

TEST_F(Assemble, NamesTheTileThatIsMissing) {
  EXPECT_EQ(refusal({"t1.png", "t3.png"}),
            "sweepkit: tile 2 of 3 is missing (2 are given); draw it with --tile 2/3\n");
  EXPECT_EQ(refusal({"t1.png", "t2.png"}),
            "sweepkit: tile 3 of 3 is missing (2 are given); draw it with --tile 3/3\n");
}

TEST_F(Assemble, NamesTheTileThatIsThereTwice) {
  workshop_.shell("cp t2.png again.png");
  EXPECT_EQ(refusal({"t1.png", "t2.png", "t3.png", "again.png"}),
            "sweepkit: again.png: is tile 2 again, as t2.png is\n");
}

TEST_F(Assemble, RefusesTilesOfAnotherPicture) {
  const std::string other =
      "sweepkit: o.png: is of another picture than t1.png: the scene, its files, the options, the frame or "
      "the program differ; draw both again\n";
  for (const Arguments& more : {Arguments{"--filter", "point"}, Arguments{"--set", "/depth=1"},
                                Arguments{"--exposure", "1"}, Arguments{"--antialias", "3x3"}}) {
    draw("o.png", "2/3", more);
    EXPECT_EQ(refusal({"t1.png", "o.png", "t3.png"}), other);
  }
  const std::string cut =
      "sweepkit: o.png: is cut otherwise than t1.png: tile 2/4 beside 1/3, or of another --size or --crop\n";
  draw("o.png", "2/4", {});
  EXPECT_EQ(refusal({"t1.png", "o.png", "t3.png"}), cut);
  draw("o.png", "2/3", {"--crop", "0,0,61,46"});
  EXPECT_NE(refusal({"t1.png", "o.png", "t3.png"}).find("is cut otherwise than t1.png"), std::string::npos);
}

TEST_F(Assemble, RefusesWhatIsNoTileOrNoTileAnyMore) {
  workshop_.sweepkit({"render", "scene.json", "-o", "plain.png"});
  EXPECT_EQ(refusal({"plain.png"}),
            "sweepkit: plain.png: is no tile; draw it with sweepkit render --tile I/N\n");
  EXPECT_EQ(refusal({"none.png"}), "sweepkit: none.png: no such file\n");
  EXPECT_NE(refusal({"scene.json"}).find("scene.json: cannot be read as an image"), std::string::npos);
  EXPECT_EQ(refusal({"t1.png", "t2.png", "t3.png"}, "out.exr"),
            "sweepkit: out.exr: the tiles are .png files, and so is what they are put together to\n");
  EXPECT_EQ(refusal({"t1.png", "t2.png", "t3.png"}, "out.bmp"),
            "sweepkit: out.bmp: a picture's name ends in .png, .jpg, .tif or .exr\n");
  draw("t2.tif", "2/3", {});
  EXPECT_NE(refusal({"t1.png", "t2.tif", "t3.png"}).find("has another format or other channels than t1.png"),
            std::string::npos);
  // Cut short in the middle of its pixels.
  workshop_.write("t2.png", workshop_.read("t2.png").substr(0, workshop_.read("t2.png").size() / 2));
  EXPECT_NE(refusal({"t1.png", "t2.png", "t3.png"}).find("t2.png: cannot be read as an image"),
            std::string::npos);
}

TEST_F(Assemble, TakesATileForEveryRow) {
  const Arguments size = {"--size", "8x5"};
  ASSERT_EQ(workshop_.sweepkit({"render", "scene.json", "-o", "whole.png", "--size", "8x5"}).status, 0);
  Arguments assemble = {"assemble", "-o", "out.png"};
  for (const char* tile : {"1/5", "2/5", "3/5", "4/5", "5/5"}) {
    std::string file = "r0.png";
    file[1] = tile[0];
    draw(file, tile, size);
    assemble.push_back(file);
  }
  ASSERT_EQ(workshop_.sweepkit(assemble).status, 0);
  EXPECT_EQ(workshop_.read("out.png"), workshop_.read("whole.png"));
}

TEST_F(Assemble, GoesToStandardOutputInTheTilesOwnFormat) {
  workshop_.sweepkit({"render", "scene.json", "-o", "whole.png"});
  const Outcome run = workshop_.sweepkit({"assemble", "t1.png", "t2.png", "t3.png", "-o", "-"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, workshop_.read("whole.png"));
}

TEST_F(Assemble, OntoAFullDiskFailsAndLeavesNothing) {
  const auto before = workshop_.contents();
  const Outcome run =
      workshop_.sweepkit({"assemble", "t1.png", "t2.png", "t3.png", "-o", "/dev/full", "--format", "png"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "sweepkit: /dev/full: cannot be written: No space left on device\n");
  EXPECT_EQ(workshop_.contents(), before);
}

TEST_F(Assemble, TilesOfAFrameMakeThatFrame) {
  const Arguments frame = {"--frames", "2", "--frames-per-turn", "5"};
  const Outcome run = workshop_.sweepkit(
      {"render", "scene.json", "-o", "whole.png", "--frames", "2", "--frames-per-turn", "5"});
  ASSERT_EQ(run.status, 0) << run.err;
  draw("f1.png", "1/2", frame);
  draw("f2.png", "2/2", frame);
  ASSERT_EQ(workshop_.sweepkit({"assemble", "f1.png", "f2.png", "-o", "out.png"}).status, 0);
  EXPECT_EQ(workshop_.read("out.png"), workshop_.read("whole.png"));
  draw("g2.png", "2/2", {"--frames", "3", "--frames-per-turn", "5"});
  EXPECT_NE(refusal({"f1.png", "g2.png"}).find("is of another picture than f1.png"), std::string::npos);
}

}  // namespace
}  // namespace sweepkit::test
