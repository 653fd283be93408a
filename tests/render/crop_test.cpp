// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "draw.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::render {
namespace {

const char* const kTiled =
    R"({"sweepkit": 1, "camera": {"eye": [0, 1, 4], "target": [0, 0.4, 0], "width": 61, "height": 43},
  "textures": {"tiles": {"procedural": "checker", "scale": 0.05}},
  "materials": {"floor": {"texture": "tiles", "reflect": 0.3}, "ball": {"diffuse": [0.8, 0.3, 0.2], "reflect": 0.2}},
  "objects": [{"name": "floor", "material": "floor", "plane": {"size": [8, 8]}},
              {"name": "ring", "material": "ball", "translate": [0, 0.6, 0], "rotate_deg": [80, 0, 0],
               "tessellation": {"contour": 16, "trajectory": 40}, "sweep": {"contour": {"circle": {"radius": 0.2}}, "trajectory": {"circle": {"radius": 0.5}}}}]})";

TEST(Crop, IsThatPartOfTheWholePictureToTheBit) {
  const test::Stage stage(kTiled);
  for (const int supersampling : {1, 3}) {
    const Picture whole = stage.draw({.supersampling = supersampling});
    for (const Region& crop :
         {Region{0, 0, 61, 43}, Region{17, 9, 30, 21}, Region{60, 42, 1, 1}, Region{0, 40, 61, 3}}) {
      const Picture part = stage.draw({.supersampling = supersampling, .crop = crop});
      ASSERT_EQ(part.image.width, crop.width);
      ASSERT_EQ(part.image.height, crop.height);
      for (int y = 0; y < crop.height; ++y) {
        const float* expected = test::texels(whole).data() + 3 * ((crop.y + y) * 61 + crop.x);
        ASSERT_TRUE(
            std::equal(expected, expected + 3 * crop.width, test::texels(part).data() + 3 * y * crop.width));
      }
    }
  }
}

TEST(Crop, IsThatPartOfARefinedPictureToTheBit) {
  const test::Stage stage(kTiled);
  for (const Shadows shadows : {Shadows::kHard, Shadows::kSmooth}) {
    const Options options{.adaptive = Adaptive{}, .shadows = shadows, .layers = {Layer::kRays}};
    const Picture whole = stage.draw(options);
    for (const Region& crop :
         {Region{0, 0, 61, 43}, Region{17, 9, 30, 21}, Region{60, 42, 1, 1}, Region{0, 40, 61, 3}}) {
      Options part_options = options;
      part_options.crop = crop;
      const Picture part = stage.draw(part_options);
      for (int y = 0; y < crop.height; ++y) {
        const int from = (crop.y + y) * 61 + crop.x;
        const float* expected = test::texels(whole).data() + 3 * from;
        ASSERT_TRUE(
            std::equal(expected, expected + 3 * crop.width, test::texels(part).data() + 3 * y * crop.width));
        const std::vector<float> rays = test::eye_rays(whole);
        ASSERT_TRUE(std::equal(rays.begin() + from, rays.begin() + from + crop.width,
                               test::eye_rays(part).begin() + y * crop.width));
      }
    }
  }
}

TEST(Crop, OutsideThePictureIsRefused) {
  const test::Stage stage(kTiled);
  for (const Region& crop :
       {Region{-1, 0, 5, 5}, Region{0, 0, 0, 5}, Region{57, 0, 5, 5}, Region{0, 43, 1, 1}})
    EXPECT_THROW(stage.draw({.crop = crop}), InputError);
}

}  // namespace
}  // namespace sweepkit::render
