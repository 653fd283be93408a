// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "draw.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

texmap::Image checker_image(int cells) {
  const int size = 256;
  texmap::Image image{size, size, 1, std::vector<std::uint16_t>(size * size)};
  auto& values = std::get<std::vector<std::uint16_t>>(image.texels);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const bool is_white = (x * cells / size + y * cells / size) % 2 == 0;
      values[static_cast<std::size_t>(y * size + x)] = is_white ? 65535 : 0;
    }
  }
  return image;
}

std::string floor_scene(const std::string& objects) {
  return R"({"sweepkit": 1, "camera": {"eye": [0, 1.5, 6], "target": [0, 0.6, 0], "fov_deg": 45, "width": 160, "height": 120},
    "background": [0.5, 0.5, 0.5], "ambient": [1, 1, 1], "depth": 2, "textures": {"t": {"procedural": "checker"}},
    "materials": {"floor": {"diffuse": [1, 1, 1], "texture": "t"}, "mirror": {"diffuse": [0, 0, 0], "reflect": 1}}, "objects": [)" +
         objects + "]}";
}

const char* const kFloor =
    R"({"name": "floor", "material": "floor", "plane": {"size": [40, 40]}, "uv": {"repeat": [10, 10]}})";

TEST(TextureFilter, LowersTheErrorOfAFarFloorAndOfItsReflection) {
  Stage plain(floor_scene(kFloor));
  Stage mirrored(floor_scene(
      std::string(kFloor) +
      R"(, {"name": "mirror", "material": "mirror", "translate": [0, 2, -3], "rotate_deg": [90, 0, 0], "plane": {"size": [6, 4]}})"));
  for (Stage* stage : {&plain, &mirrored}) {
    stage->set_texture(0, checker_image(8));
    const Picture reference = stage->draw({.filter = Filter::kPoint, .supersampling = 16});
    const double point = texmap::rmse(stage->draw({.filter = Filter::kPoint}).image, reference.image);
    const double paper =
        texmap::rmse(stage->draw({.footprint = Footprint::kNeighbours}).image, reference.image);
    const double halved = texmap::rmse(stage->draw().image, reference.image);
    EXPECT_LT(paper, point);
    EXPECT_LT(halved, 0.6 * point);
    EXPECT_LT(halved, paper);
  }
}

TEST(TextureFilter, LeavesNoLineAtTheSeam) {
  // A tube seen along its seam, its texture constant but for noise of one level: filtered over the seam it
  // stays so.
  Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [4, 0, 0], "target": [0, 0, 0], "fov_deg": 30, "width": 120, "height": 40},
    "ambient": [1, 1, 1], "textures": {"t": {"procedural": "checker"}}, "materials": {"m": {"diffuse": [1, 1, 1], "texture": "t"}},
    "objects": [{"name": "tube", "material": "m", "tessellation": {"contour": 1, "trajectory": 64}, "revolve": {"contour": {"line": [[1, -2], [1, 2]]}}}]})");
  // Dark on the far side, light about the seam (u = 0): a box over the whole texture would show a dark line
  // there.
  texmap::Image image{64, 1, 1, std::vector<std::uint16_t>(64)};
  auto& values = std::get<std::vector<std::uint16_t>>(image.texels);
  for (std::size_t i = 0; i < 64; ++i) values[i] = i < 16 || i >= 48 ? 60000 : 0;
  stage.set_texture(0, image);
  const Picture picture = stage.draw();
  for (int x = 50; x < 70; ++x) EXPECT_NEAR(picture.image.color(x, 20).r, 60000 / 65535.0, 1e-5) << x;
}

TEST(TextureFilter, CountsWhatItFilters) {
  Stage stage(floor_scene(kFloor));
  stage.set_texture(0, checker_image(8));
  const Statistics with = stage.draw().statistics;
  EXPECT_GT(with.filtered_nodes, 0u);
  // All but the row at the horizon, whose neighbours escape.
  EXPECT_LE(with.textured_nodes - with.filtered_nodes, 3u * 160);
  EXPECT_EQ(stage.draw({.filter = Filter::kPoint}).statistics.filtered_nodes, 0u);
}

TEST(TextureFilter, AgreesWithPointSamplingWhereTheTextureIsConstant) {
  Stage stage(floor_scene(kFloor));
  stage.set_texture(0, texmap::Image{4, 4, 1, std::vector<std::uint16_t>(16, 30000)});
  EXPECT_NEAR(texmap::rmse(stage.draw().image, stage.draw({.filter = Filter::kPoint}).image), 0, 1e-7);
}

}  // namespace
}  // namespace sweepkit::render
