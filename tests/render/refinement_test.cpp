// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "draw.hpp"
#include "pixel_pattern.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

// Rods before a wall, lit: edges in every direction, and their shadows.
const char* const kEdges =
    R"({"sweepkit": 1, "camera": {"eye": [0.4, 1.2, 5], "target": [0, 0.5, 0], "fov_deg": 40, "width": 96, "height": 72},
  "background": [0.9, 0.9, 0.9], "ambient": [0.2, 0.2, 0.2], "lights": [{"point": [3, 5, 4], "intensity": [0.8, 0.8, 0.8]}],
  "materials": {"dark": {"diffuse": [0.15, 0.1, 0.1]}, "wall": {"diffuse": [0.9, 0.9, 0.8]}},
  "objects": [{"name": "floor", "material": "wall", "plane": {"size": [4, 4]}},
    {"name": "knot", "material": "dark", "translate": [0, 0.8, 0], "tessellation": {"contour": 12, "trajectory": 128},
     "sweep": {"contour": {"circle": {"radius": 0.07}}, "trajectory": {"torus_knot": {"p": 2, "q": 3, "radius": 0.8, "tube": 0.3}}}}]})";

TEST(Refinement, BeatsThreeByThreeWithFewerRaysWhereThereAreEdges) {
  const Stage stage(kEdges);
  const Picture reference = stage.draw({.supersampling = 24, .shadows = Shadows::kHard});
  const Picture uniform = stage.draw({.supersampling = 3, .shadows = Shadows::kHard});
  const Picture refined = stage.draw({.adaptive = Adaptive{}});
  EXPECT_LT(refined.statistics.eye_rays, uniform.statistics.eye_rays);
  EXPECT_LT(texmap::rmse(refined.image, reference.image), texmap::rmse(uniform.image, reference.image));
}

TEST(Refinement, HasLessErrorTheSmallerTheContrast) {
  const Stage stage(kEdges);
  const Picture reference = stage.draw({.supersampling = 24, .shadows = Shadows::kHard});
  double before = texmap::rmse(stage.draw().image, reference.image);
  for (const double contrast : {0.5, 0.1, 0.02}) {
    const Picture picture = stage.draw({.adaptive = Adaptive{.contrast = contrast, .most_rays = 256}});
    const double error = texmap::rmse(picture.image, reference.image);
    EXPECT_LT(error, before) << contrast;
    before = error;
  }
}

TEST(Refinement, LeavesAPictureWithoutDifferencesAtOneRayAPixel) {
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 3, 0.001], "target": [0, 0, 0], "fov_deg": 40, "width": 20, "height": 12},
    "lights": [{"point": [0, 40, 0]}], "objects": [{"name": "plane", "plane": {"size": [40, 40]}}]})");
  const Picture one = stage.draw({.shadows = Shadows::kHard});
  const Picture refined =
      stage.draw({.adaptive = Adaptive{}, .shadows = Shadows::kHard, .layers = {Layer::kRays}});
  EXPECT_EQ(refined.statistics.refined_pixels, 0u);
  EXPECT_EQ(refined.statistics.refining_rays, 0u);
  // A border of one pixel is shaded to compare with.
  EXPECT_EQ(refined.statistics.eye_rays, 22u * 14);
  EXPECT_EQ(test::eye_rays(refined), std::vector<float>(20 * 12, 1));
  EXPECT_EQ(test::texels(one), test::texels(refined));
}

TEST(Refinement, CountsItsRaysAndNeverGoesPastTheMost) {
  const Stage stage(kEdges);
  for (const int most : {4, 16, 100, 256}) {
    const Picture picture =
        stage.draw({.adaptive = Adaptive{.contrast = 1e-4, .most_rays = most}, .layers = {Layer::kRays}});
    std::uint64_t rays = 0;
    std::uint64_t pixels = 0;
    for (const float value : test::eye_rays(picture)) {
      const int count = static_cast<int>(value);
      EXPECT_LE(count, most + 1);
      rays += static_cast<std::uint64_t>(count - 1);
      pixels += count > 1 ? 1 : 0;
    }
    EXPECT_EQ(picture.statistics.refining_rays, rays);
    EXPECT_EQ(picture.statistics.refined_pixels, pixels);
    EXPECT_GT(std::ranges::max(test::eye_rays(picture)), static_cast<float>(most / 2));
  }
}

TEST(Refinement, CountsTheRaysOfUniformSupersamplingToo) {
  const Stage stage(kEdges);
  EXPECT_EQ(test::eye_rays(stage.draw({.supersampling = 3, .layers = {Layer::kRays}})),
            std::vector<float>(96 * 72, 9));
}

// In a mirror that fills the picture every ray meets the same object: only the path tells the edges.
TEST(Refinement, SeesEdgesInAMirror) {
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 0, 2], "target": [0, 0, 0], "fov_deg": 30, "width": 40, "height": 40},
    "ambient": [1, 1, 1], "background": [0.5, 0.5, 0.5], "materials": {"mirror": {"diffuse": [0, 0, 0], "reflect": 1}, "grey": {"diffuse": [0.5, 0.5, 0.5]}},
    "objects": [{"name": "mirror", "material": "mirror", "rotate_deg": [90, 0, 0], "plane": {"size": [8, 8]}},
      {"name": "behind", "material": "grey", "translate": [1.2, 0, 3], "rotate_deg": [90, 0, 0], "plane": {"size": [2, 9]}}]})");
  const Picture picture = stage.draw({.adaptive = Adaptive{}, .layers = {Layer::kRays}});
  // The grey plate is as grey as the background: its edge shows in no colour, but it is an edge.
  EXPECT_GE(picture.statistics.refined_pixels, 40u);
  EXPECT_LE(picture.statistics.refined_pixels, 2u * 40);
  for (const float value : test::texels(picture)) EXPECT_EQ(value, 0.5f);
}

TEST(Refinement, LeavesTexturesToTheFilterThatAveragesThemOverThePixel) {
  Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 1.5, 6], "target": [0, 0, 0], "fov_deg": 20, "width": 64, "height": 48},
    "ambient": [1, 1, 1], "textures": {"t": {"procedural": "checker"}}, "materials": {"floor": {"diffuse": [1, 1, 1], "texture": "t"}},
    "objects": [{"name": "floor", "material": "floor", "plane": {"size": [100, 100]}, "uv": {"repeat": [20, 20]}}]})");
  texmap::Image checks{64, 64, 1, std::vector<std::uint16_t>(64 * 64)};
  auto& values = std::get<std::vector<std::uint16_t>>(checks.texels);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = (i / 8 + i / 512) % 2 == 0 ? 65535 : 0;
  stage.set_texture(0, checks);
  const Options by_box{.adaptive = Adaptive{}};
  const Options by_points{.filter = Filter::kPoint, .adaptive = Adaptive{}};
  EXPECT_EQ(stage.draw(by_box).statistics.refined_pixels, 0u);
  EXPECT_GT(stage.draw(by_points).statistics.refined_pixels, 500u);
  // And it is as good, or the contrast would have to count: one ray a pixel against a grid of 5 x 5.
  const Picture reference = stage.draw({.filter = Filter::kPoint, .supersampling = 32});
  EXPECT_LT(texmap::rmse(stage.draw(by_box).image, reference.image),
            texmap::rmse(stage.draw({.filter = Filter::kPoint, .supersampling = 5}).image, reference.image));
}

TEST(Refinement, RefusesOptionsOutOfRange) {
  const Stage stage(kEdges);
  EXPECT_THROW(stage.draw({.supersampling = 3, .adaptive = Adaptive{}}), InputError);
  EXPECT_THROW(stage.draw({.adaptive = Adaptive{.contrast = 0}}), InputError);
  EXPECT_THROW(stage.draw({.adaptive = Adaptive{.contrast = std::nan("")}}), InputError);
  EXPECT_THROW(stage.draw({.adaptive = Adaptive{.most_rays = 3}}), InputError);
  EXPECT_THROW(stage.draw({.adaptive = Adaptive{.most_rays = 257}}), InputError);
}

// A (0, 2)-sequence: however 2^k boxes of equal size are laid over the square, its first 2^k places lie one
// in each.
TEST(PixelPattern, HasOnePlaceInEveryBoxOfEveryPowerOfTwo) {
  const std::span<const glm::dvec2> places = pixel_pattern();
  ASSERT_EQ(places.size(), 256u);
  for (int k = 0; k <= 8; ++k) {
    for (int columns = 0; columns <= k; ++columns) {
      std::set<std::pair<int, int>> boxes;
      for (std::size_t i = 0; i < std::size_t{1} << k; ++i) {
        boxes.emplace(static_cast<int>(places[i].x * (1 << columns)),
                      static_cast<int>(places[i].y * (1 << (k - columns))));
      }
      EXPECT_EQ(boxes.size(), std::size_t{1} << k) << k << ' ' << columns;
    }
  }
}

}  // namespace
}  // namespace sweepkit::render
