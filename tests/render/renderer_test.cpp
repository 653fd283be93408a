// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "draw.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/turntable.hpp"

namespace sweepkit::render {
namespace {

const char* const kScene =
    R"({"sweepkit": 1, "camera": {"eye": [0, 1, 4], "target": [0, 0.4, 0], "width": 61, "height": 43},
  "background": [0.1, 0.2, 0.3], "textures": {"tiles": {"procedural": "checker", "scale": 0.05}},
  "materials": {"floor": {"texture": "tiles", "reflect": 0.3}},
  "objects": [{"name": "floor", "material": "floor", "plane": {"size": [8, 8]}},
              {"name": "ring", "translate": [0, 0.6, 0], "rotate_deg": [80, 0, 0],
               "tessellation": {"contour": 16, "trajectory": 40}, "sweep": {"contour": {"circle": {"radius": 0.2}}, "trajectory": {"circle": {"radius": 0.5}}}}]})";

TEST(Renderer, DrawsEachViewAsARenderOfItsOwnWould) {
  test::Stage stage(kScene);
  stage.set_texture(0, texmap::Image{4, 4, 1, std::vector<std::uint16_t>(16, 30000)});
  const Options options;
  const scene::Plan plan = test::plan_for(stage.document, options);
  const Renderer renderer(stage.model.scene, plan, options);
  const scene::Camera camera = stage.model.scene.camera;
  for (const double degrees : {0.0, 40.0, 0.0}) {
    look_from(stage.model.scene, stage.document, turned(camera, degrees));
    EXPECT_EQ(test::texels(renderer.draw()), test::texels(stage.draw())) << degrees;
  }
}

TEST(Renderer, ReadsTilesOnceForAllPictures) {
  test::Stage stage(kScene);
  stage.set_texture(0, texmap::Image{64, 64, 1, std::vector<std::uint16_t>(64 * 64, 30000)});
  const scene::Plan plan = test::plan_for(stage.document, {});
  const Renderer renderer(stage.model.scene, plan, {});
  EXPECT_GT(renderer.draw().ledger[scene::Part::kTiles].calls, 0u);
  EXPECT_EQ(renderer.draw().ledger[scene::Part::kTiles].calls, 0u);
}

TEST(Renderer, DrawsAPreviewOfOneRayABlockThroughItsMiddle) {
  const test::Stage stage(kScene);
  const Options options{.supersampling = 3, .layers = {Layer::kObjectId}};
  const scene::Plan plan = test::plan_for(stage.document, options);
  const Renderer renderer(stage.model.scene, plan, options);
  // An even part of the larger picture: the coarse one drawn by itself.
  test::Stage coarse(kScene);
  for (const int step : {2, 8}) {
    coarse.model.scene.width = 64 / step;
    coarse.model.scene.height = 48 / step;
    test::Stage fine(kScene);
    fine.model.scene.width = 64;
    fine.model.scene.height = 48;
    const Renderer fine_renderer(fine.model.scene, plan, options);
    const Picture preview = fine_renderer.draw(step);
    const Picture expected = coarse.draw();
    ASSERT_EQ(preview.image.width, 64);
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) {
        ASSERT_EQ(preview.image.color(x, y), expected.image.color(x / step, y / step)) << x << ", " << y;
      }
    }
  }
  // 61 x 43 pixels are 8 x 6 blocks of 8 x 8, those at the ends cut.
  const Picture preview = renderer.draw(8);
  EXPECT_EQ(preview.image.width, 61);
  EXPECT_EQ(preview.image.height, 43);
  EXPECT_EQ(preview.layers[0].image.height, 43);
  EXPECT_EQ(preview.statistics.layer_rays, 0u);
  EXPECT_LE(preview.statistics.eye_rays, 10u * 8);  // with the filter's border
  // A ray through the middle of block (3, 2) is one through the corner of pixels that meet there.
  EXPECT_EQ(preview.image.color(24, 16), preview.image.color(31, 23));
}

TEST(Renderer, DrawsThePreviewOfACropAsThatPartOfTheWholes) {
  const test::Stage stage(kScene);
  const scene::Plan plan = test::plan_for(stage.document, {});
  const Region crop{13, 5, 30, 21};
  const Renderer renderer(stage.model.scene, plan, {.crop = crop});
  for (const int step : {2, 4, 8}) {
    const Picture whole = Renderer(stage.model.scene, plan, {}).draw(step);
    const Picture part = renderer.draw(step);
    for (int y = 0; y < crop.height; ++y) {
      for (int x = 0; x < crop.width; ++x)
        ASSERT_EQ(part.image.color(x, y), whole.image.color(crop.x + x, crop.y + y)) << step;
    }
  }
}

TEST(Renderer, RefusesAStepOfNone) {
  const test::Stage stage(kScene);
  EXPECT_THROW(Renderer(stage.model.scene, test::plan_for(stage.document, {}), {}).draw(0), InputError);
}

}  // namespace
}  // namespace sweepkit::render
