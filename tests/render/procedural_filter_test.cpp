// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "draw.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

// A floor to the horizon and a mirror that shows it, its texture given.
std::string floor_scene(const std::string& texture) {
  return R"({"sweepkit": 1, "camera": {"eye": [0, 1.5, 6], "target": [0, 0.6, 0], "fov_deg": 45, "width": 120, "height": 90},
    "background": [0.5, 0.5, 0.5], "ambient": [1, 1, 1], "depth": 2, "textures": {"t": {"procedural": )" +
         texture +
         R"(}}, "materials": {"floor": {"diffuse": [1, 1, 1], "texture": "t"}, "mirror": {"diffuse": [0, 0, 0], "reflect": 1}},
    "objects": [{"name": "floor", "material": "floor", "rotate_deg": [0, 35, 0], "plane": {"size": [60, 60]}, "uv": {"size": 1}},
                {"name": "mirror", "material": "mirror", "translate": [0, 2, -3], "rotate_deg": [90, 0, 0], "plane": {"size": [6, 4]}}]})";
}

TEST(ProceduralTextures, AreFilteredOnTheFloorAndInTheMirror) {
  for (const char* texture :
       {R"("checker")", R"("brick")", R"("marble", "scale": 2)", R"("tiles", "on": "position")"}) {
    const Stage stage(floor_scene(texture));
    const Picture reference = stage.draw({.filter = Filter::kPoint, .supersampling = 12});
    const double point = texmap::rmse(stage.draw({.filter = Filter::kPoint}).image, reference.image);
    const double filtered = texmap::rmse(stage.draw().image, reference.image);
    // What is left lies at the silhouettes, which textures' filters do not see.
    EXPECT_LT(filtered, 0.6 * point) << texture;
  }
}

TEST(ProceduralTextures, AreFilteredByEveryFilterButPoint) {
  const Stage stage(floor_scene(R"("checker")"));
  const Picture first = stage.draw({.filter = Filter::kAuto});
  EXPECT_GT(first.statistics.filtered_nodes, 0u);
  for (const Filter filter : {Filter::kBilinear, Filter::kTrilinear, Filter::kIntegral1, Filter::kEwa})
    EXPECT_EQ(test::texels(stage.draw({.filter = filter})), test::texels(first));
  const Picture point = stage.draw({.filter = Filter::kPoint});
  EXPECT_EQ(point.statistics.filtered_nodes, 0u);
  EXPECT_NE(test::texels(point), test::texels(first));
  EXPECT_EQ(point.ledger[scene::Part::kRows].calls, 0u);
}

TEST(ProceduralTextures, ShowNoLineAtTheSeam) {
  // A tube seen along its seam, checked so finely that it is its mean but where a footprint goes wrong: one
  // that took the long way round would be that, too, so the tube is coarse: 8 cells of which 2 are in view.
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [4, 0, 0], "target": [0, 0, 0], "fov_deg": 30, "width": 120, "height": 40},
    "ambient": [1, 1, 1], "textures": {"t": {"procedural": "checker", "scale": 4, "colors": [[1, 1, 1], [0, 0, 0]]}},
    "materials": {"m": {"diffuse": [1, 1, 1], "texture": "t"}},
    "objects": [{"name": "tube", "material": "m", "tessellation": {"contour": 1, "trajectory": 64},
                 "uv": {"repeat": [1, 0.001]}, "revolve": {"contour": {"line": [[1, -2], [1, 2]]}}}]})");
  const Picture picture = stage.draw();
  int between = 0;
  for (int x = 40; x < 80; ++x) {
    const float value = picture.image.color(x, 20).r;
    between += value > 0.02f && value < 0.98f ? 1 : 0;
  }
  // The edges between cells, at the seam and an eighth of the turn to either side, take two pixels each.
  EXPECT_LE(between, 6);
}

TEST(ProceduralTextures, AreTheSameBytesForAnyNumberOfThreads) {
  const Stage stage(floor_scene(R"("granite")"));
  EXPECT_EQ(test::texels(stage.draw({.threads = 1})), test::texels(stage.draw({.threads = 3})));
}

}  // namespace
}  // namespace sweepkit::render
