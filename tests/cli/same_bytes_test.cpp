// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// The same bytes with 1, 2 and 7 threads and twice in a row, for every output format. The scene has
// everything that could differ: image and procedural textures, filters, reflections, several objects.

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

std::string mixed_scene() {
  return R"({
  "sweepkit": 1,
  "camera": {"eye": [3, 2, 4], "target": [0, 0, 0], "width": 160, "height": 96},
  "background": [0.2, 0.3, 0.4],
  "lights": [{"point": [4, 5, 6], "intensity": [0.8, 0.8, 0.8]}],
  "textures": {
    "tiles": {"image": ")" SWEEPKIT_SAMPLES R"(/textures/floor_tiles.png"},
    "marble": {"procedural": "marble", "scale": 2},
    "checks": {"procedural": "checker", "scale": 4}
  },
  "materials": {
    "floor": {"texture": "tiles", "reflect": 0.3},
    "stone": {"texture": "marble", "specular": [0.5, 0.5, 0.5]},
    "checked": {"texture": "checks", "reflect": 0.1}
  },
  "objects": [
    {"name": "floor", "material": "floor", "plane": {"size": [8, 8]}, "uv": {"repeat": [8, 8]}, "translate": [0, -1, 0]},
    {"name": "ball", "material": "stone", "revolve": {"contour": {"bezier": [[0, -1], [1.3, -1], [1.3, 1], [0, 1]]}}},
    {"name": "ring", "material": "checked",
     "sweep": {"contour": {"circle": {"radius": 0.2}}, "trajectory": {"circle": {"radius": 1.5}}}}
  ]
})";
}

std::map<std::string, std::string> files_made(std::vector<std::string> arguments) {
  const Workshop workshop;
  workshop.write("scene.json", mixed_scene());
  arguments.emplace_back("--quiet");
  const Outcome run = workshop.sweepkit(arguments);
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "") << "nor do the libraries that it stands on say a word";
  std::map<std::string, std::string> files = workshop.contents();
  files.erase("scene.json");
  return files;
}

class SameBytes : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(SameBytes, ComeOutTwiceInARow) {
  const auto first = files_made(GetParam());
  EXPECT_FALSE(first.empty());
  for (const auto& [name, digest] : first) EXPECT_NE(digest.substr(0, 2), "0 ") << name;
  EXPECT_EQ(first, files_made(GetParam()));
}

class SamePicture : public SameBytes {};

TEST_P(SamePicture, ComesOutOf1And2And7ThreadsAndTwiceInARow) {
  std::vector<std::string> arguments = GetParam();
  arguments.insert(arguments.end(), {"--threads", "1"});
  const auto one = files_made(arguments);
  EXPECT_FALSE(one.empty());
  for (const char* threads : {"2", "2", "1", "7"}) {
    arguments.back() = threads;
    EXPECT_EQ(one, files_made(arguments)) << threads << " threads";
  }
}

// "glb", "render_png_3x3", ...
std::string name_of(const testing::TestParamInfo<std::vector<std::string>>& info) {
  std::string name = info.param.front();
  for (const std::string& argument : info.param) {
    if (argument.compare(0, 4, "out.") == 0) name += "_" + argument.substr(4);
    if (argument == "--alpha") name += "_alpha";
    if (argument == "--frames") name += "_frame";
    if (argument == "3x3" || argument == "adaptive" || argument == "point") name += "_" + argument;
  }
  return name;
}

const std::vector<std::vector<std::string>> kPictures = {
    {"render", "scene.json", "-o", "out.png"},
    {"render", "scene.json", "-o", "out.jpg"},
    {"render", "scene.json", "-o", "out.tif"},
    {"render", "scene.json", "-o", "out.exr"},
    {"render", "scene.json", "-o", "out.exr", "--filter", "point"},
    {"render", "scene.json", "-o", "out.exr", "--antialias", "3x3"},
    {"render", "scene.json", "-o", "out.exr", "--antialias", "adaptive"},
    {"render", "scene.json", "-o", "out.png", "--alpha", "--bits", "16", "--aov", "depth,uv"},
    {"render", "scene.json", "-o", "out.exr", "--alpha", "--aov", "depth,normal,uv,object-id,footprint,rays"},
    {"render", "scene.json", "-o", "out.png", "--frames", "3", "--skip-existing"},
};

INSTANTIATE_TEST_SUITE_P(Pictures, SamePicture, testing::ValuesIn(kPictures), name_of);

INSTANTIATE_TEST_SUITE_P(
    Models, SameBytes,
    testing::Values(std::vector<std::string>{"generate", "scene.json", "-o", "out.glb", "--bake-size", "64"},
                    std::vector<std::string>{"generate", "scene.json", "-o", "out.gltf", "--bake-size", "64"},
                    std::vector<std::string>{"generate", "scene.json", "-o", "out.obj", "--bake-size", "64"},
                    std::vector<std::string>{"generate", "scene.json", "-o", "out.ply"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(Textures, SameBytes,
                         testing::Values(std::vector<std::string>{"bake", "scene.json", "--object", "ball",
                                                                  "--size", "64x64", "-o", "out.png"},
                                         std::vector<std::string>{"bake", "scene.json", "--object", "ball",
                                                                  "--size", "64x64", "-o", "out.jpg"},
                                         std::vector<std::string>{"bake", "scene.json", "--object", "ball",
                                                                  "--size", "64x64", "-o", "out.tif"},
                                         std::vector<std::string>{"bake", "scene.json", "--object", "ball",
                                                                  "--size", "64x64", "-o", "out.exr"}),
                         name_of);

TEST(StandardOutput, GetsTheSameBytesAsAFile) {
  const Workshop workshop;
  workshop.write("scene.json", mixed_scene());
  EXPECT_EQ(workshop.sweepkit({"generate", "scene.json", "-o", "scene.glb", "--bake-size", "64"}).status, 0);
  EXPECT_EQ(workshop.sweepkit({"generate", "scene.json", "-o", "-", "--bake-size", "64"}).out,
            workshop.read("scene.glb"));
  EXPECT_EQ(workshop.sweepkit({"render", "scene.json", "-o", "picture.png"}).status, 0);
  EXPECT_EQ(workshop.sweepkit({"render", "scene.json", "-o", "-"}).out, workshop.read("picture.png"));
  EXPECT_EQ(workshop.sweepkit({"render", "scene.json", "-o", "picture.exr"}).status, 0);
  EXPECT_EQ(workshop.sweepkit({"render", "scene.json", "-o", "-", "--format", "exr"}).out,
            workshop.read("picture.exr"));
}

}  // namespace
}  // namespace sweepkit::test
