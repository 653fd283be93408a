// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "draw.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

const std::vector<Layer> kAll = {Layer::kDepth,    Layer::kNormal,    Layer::kUv,
                                 Layer::kObjectId, Layer::kFootprint, Layer::kRays};

// From 3 m above, straight down on a plane of 2 x 2 m with a texture of 8 x 4 texels, 20 cm above it a
// smaller one without; the picture is 3 m wide at the floor, so that its rim shows the background.
const char* const kFloor =
    R"({"sweepkit": 1, "camera": {"eye": [0, 3, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov_deg": 53.13010235415598, "width": 60, "height": 60},
  "ambient": [1, 1, 1], "background": [0.2, 0.4, 0.6],
  "textures": {"t": {"procedural": "checker"}}, "materials": {"m": {"texture": "t"}},
  "objects": [{"name": "floor", "material": "m", "plane": {"size": [2, 2]}},
              {"name": "card", "translate": [0.5, 0.5, 0], "plane": {"size": [0.25, 0.25]}}]})";

Stage floor_stage() {
  Stage stage(kFloor);
  stage.set_texture(0, texmap::Image{8, 4, 1, std::vector<std::uint16_t>(32, 30000)});
  return stage;
}

const float* at(const Picture& picture, Layer layer, int x, int y) {
  for (const PictureLayer& found : picture.layers) {
    if (found.layer == layer)
      return std::get<std::vector<float>>(found.image.texels).data() +
             found.image.channels * (y * found.image.width + x);
  }
  throw std::runtime_error("no such layer");
}

TEST(Layers, HaveTheClosedFormOfAPlane) {
  const Picture picture = floor_stage().draw({.layers = kAll});
  ASSERT_EQ(picture.layers.size(), 6u);
  // A pixel is 3 m / 60 = 5 cm wide on the floor: 0.05 / 2 * 8 = 0.2 texels along x, 0.1 along z.
  for (const auto& [x, y] : {std::pair{15, 20}, {30, 45}, {11, 48}}) {
    const double world_x = 0.05 * (x + 0.5) - 1.5;
    const double world_z = 0.05 * (y + 0.5) - 1.5;
    // float32 rounds to 6e-8 of the value.
    EXPECT_NEAR(*at(picture, Layer::kDepth, x, y), 3, 4e-7) << "along the axis, not the ray";
    EXPECT_EQ(at(picture, Layer::kNormal, x, y)[1], 1);
    EXPECT_EQ(at(picture, Layer::kNormal, x, y)[0], 0);
    EXPECT_NEAR(at(picture, Layer::kUv, x, y)[0], 0.5 + world_x / 2, 1e-7);
    EXPECT_NEAR(at(picture, Layer::kUv, x, y)[1], 0.5 - world_z / 2, 1e-7);
    EXPECT_EQ(*at(picture, Layer::kObjectId, x, y), 1);
    EXPECT_NEAR(at(picture, Layer::kFootprint, x, y)[0], 0.2, 1e-7);
    EXPECT_NEAR(at(picture, Layer::kFootprint, x, y)[1], 0.1, 1e-7);
    EXPECT_EQ(*at(picture, Layer::kRays, x, y), 1);
  }
  // The card's middle, at x = 0.5 and 2.5 m from the eye, is seen at tan = 0.2.
  EXPECT_NEAR(*at(picture, Layer::kDepth, 41, 30), 2.5, 4e-7);
  EXPECT_EQ(*at(picture, Layer::kObjectId, 41, 30), 2);
  EXPECT_EQ(at(picture, Layer::kFootprint, 41, 30)[0], 0) << "no image texture";
  for (const Layer layer : kAll) {
    EXPECT_EQ(*at(picture, layer, 2, 2), layer == Layer::kRays ? 1 : 0) << "of the background";
  }
}

TEST(Layers, AreOfThePixelsMiddleWhateverTheAntialiasing) {
  const Stage stage = floor_stage();
  const Picture once = stage.draw({.layers = kAll});
  EXPECT_EQ(once.statistics.layer_rays, 0u) << "the picture's own rays are the same";
  for (const int supersampling : {2, 3}) {
    const Picture often = stage.draw({.supersampling = supersampling, .layers = kAll});
    EXPECT_EQ(often.statistics.layer_rays, 60u * 60);
    for (std::size_t i = 0; i < kAll.size(); ++i) {
      if (kAll[i] == Layer::kRays) {
        EXPECT_EQ(*at(often, Layer::kRays, 5, 5), supersampling * supersampling);
      } else {
        EXPECT_EQ(often.layers[i].image.texels, once.layers[i].image.texels) << kind_of(kAll[i]).name;
      }
    }
  }
}

TEST(Layers, DoNotChangeThePictureAndAreTheSameForThreadsAndCrops) {
  const Stage stage = floor_stage();
  const Picture plain = stage.draw();
  const Picture whole = stage.draw({.layers = kAll, .threads = 1});
  EXPECT_EQ(test::texels(plain), test::texels(whole));
  const Picture threads = stage.draw({.layers = kAll, .threads = 7});
  const Region crop{7, 13, 31, 40};
  const Picture part = stage.draw({.crop = crop, .layers = kAll});
  for (std::size_t i = 0; i < kAll.size(); ++i) {
    EXPECT_EQ(whole.layers[i].image.texels, threads.layers[i].image.texels);
    const int channels = whole.layers[i].image.channels;
    for (int y = 0; y < crop.height; ++y) {
      const float* expected = at(whole, kAll[i], crop.x, crop.y + y);
      EXPECT_TRUE(std::equal(expected, expected + channels * crop.width, at(part, kAll[i], 0, y)));
    }
  }
}

TEST(Layers, AskedForTwiceAreRefused) {
  EXPECT_THROW(floor_stage().draw({.layers = {Layer::kUv, Layer::kUv}}), InputError);
}

TEST(Layers, NormalsFaceTheViewerOnBothSidesAndAreUnit) {
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 1, 4], "target": [0, 0, 0], "width": 40, "height": 40},
    "objects": [{"name": "open", "tessellation": {"contour": 24, "trajectory": 24},
                 "revolve": {"contour": {"polyline": [[0.5, -1], [1, 1]]}, "caps": "none"}}]})");
  const Picture picture = stage.draw({.layers = {Layer::kNormal, Layer::kObjectId}});
  int count = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      if (*at(picture, Layer::kObjectId, x, y) == 0) continue;
      const float* n = at(picture, Layer::kNormal, x, y);
      EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 2e-7);
      ++count;
    }
  }
  EXPECT_GT(count, 200);
  // Through the opening the inner wall is seen, whose normal comes towards the viewer as the outer one's
  // does.
  EXPECT_GT(at(picture, Layer::kNormal, 20, 9)[2], 0);
  EXPECT_GT(at(picture, Layer::kNormal, 20, 25)[2], 0);
}

TEST(Alpha, IsTheShareOfThePixelThatIsCovered) {
  // A half plane whose edge runs through the middle of column 4.
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 1, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov_deg": 90, "width": 9, "height": 9},
    "ambient": [1, 1, 1], "background": [9, 9, 9], "materials": {"white": {"diffuse": [1, 0.5, 0.25]}},
    "objects": [{"name": "half", "material": "white", "translate": [5, 0, 0], "plane": {"size": [10, 10]}}]})");
  const Picture picture = stage.draw({.supersampling = 16, .has_alpha = true});
  ASSERT_EQ(picture.image.channels, 4);
  const auto pixel = [&](int x) {
    const float* p = test::texels(picture).data() + 4 * (4 * 9 + x);
    return std::array{p[0], p[1], p[2], p[3]};
  };
  EXPECT_EQ(pixel(3), (std::array{0.0f, 0.0f, 0.0f, 0.0f})) << "the background is left out";
  EXPECT_EQ(pixel(4), (std::array{0.5f, 0.25f, 0.125f, 0.5f})) << "multiplied by the coverage";
  EXPECT_EQ(pixel(5), (std::array{1.0f, 0.5f, 0.25f, 1.0f}));
}

TEST(Alpha, LeavesColoursWhereNothingOfTheBackgroundShows) {
  const Stage stage = floor_stage();
  const Picture with = stage.draw({.supersampling = 3, .has_alpha = true});
  const Picture without = stage.draw({.supersampling = 3});
  int covered = 0;
  for (std::size_t i = 0; i < 3600; ++i) {
    const float* rgba = test::texels(with).data() + 4 * i;
    if (rgba[3] != 1) continue;
    ++covered;
    EXPECT_TRUE(std::equal(rgba, rgba + 3, test::texels(without).data() + 3 * i));
  }
  EXPECT_GT(covered, 1200);  // 4 of 9 m^2 of 3600 pixels, but for their rims
}

}  // namespace
}  // namespace sweepkit::render
