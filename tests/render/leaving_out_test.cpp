// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "draw.hpp"

namespace sweepkit::render {
namespace {

using scene::Part;
using test::Stage;

void expect_nothing(const scene::Ledger& ledger, Part part) {
  EXPECT_EQ(ledger[part].bytes, 0u) << scene::part_name(part);
  EXPECT_EQ(ledger[part].calls, 0u) << scene::part_name(part);
}

TEST(LeavingOut, APlainSceneCostsNoTextureTableRowTreeOrObjectTree) {
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 32, "height": 32},
    "objects": [{"name": "torus", "sweep": {"contour": {"circle": {"radius": 0.5}}, "trajectory": {"circle": {"radius": 1.2}}}}]})");
  const Picture picture = stage.draw({.shadows = Shadows::kHard});
  for (const Part part :
       {Part::kHalfEdges,     Part::kTextures,      Part::kBakes,         Part::kTables,
        Part::kTiles,         Part::kTexcoords,     Part::kFilteredNodes, Part::kDifferentials,
        Part::kRows,          Part::kTrees,         Part::kRefractions,   Part::kShares,
        Part::kDimmedShadows, Part::kShadowEdges,   Part::kEnvironment,   Part::kSupersampling,
        Part::kRefinement,    Part::kErrorEstimate, Part::kLayers,        Part::kObjectTree,
        Part::kNormalMaps}) {
    expect_nothing(picture.ledger, part);
    expect_nothing(stage.model.ledger, part);
  }
  EXPECT_GT(picture.ledger[Part::kShadows].calls, 0u);
}

TEST(LeavingOut, WithoutALightThereIsNoShadowRay) {
  const Stage stage(
      R"({"sweepkit": 1, "ambient": [1, 1, 1], "camera": {"width": 32, "height": 32}, "objects": [{"name": "p", "plane": {"size": [1, 1]}}]})");
  const Picture picture = stage.draw();
  expect_nothing(picture.ledger, Part::kShadows);
  expect_nothing(picture.ledger, Part::kShadowEdges);
  EXPECT_EQ(picture.statistics.shadow_rays, 0u);
}

TEST(LeavingOut, EveryPartThatIsNeededShowsUp) {
  Stage stage(R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 32, "height": 32},
    "textures": {"t": {"procedural": "checker"}}, "materials": {"m": {"texture": "t", "reflect": 0.5}},
    "objects": [{"name": "a", "material": "m", "plane": {"size": [4, 4]}}, {"name": "b", "translate": [0, 1, 0], "plane": {"size": [1, 1]}}]})");
  stage.set_texture(0, texmap::Image{4, 4, 1, std::vector<std::uint16_t>(16, 30000)});
  EXPECT_GT(stage.draw({.filter = Filter::kIntegral1}).ledger[Part::kTables].calls, 0u);
  const Picture picture = stage.draw({.supersampling = 3, .layers = {Layer::kDepth}});
  for (const Part part :
       {Part::kTiles, Part::kTexcoords, Part::kFilteredNodes, Part::kRows, Part::kTrees, Part::kShadows,
        Part::kShadowEdges, Part::kSupersampling, Part::kLayers, Part::kObjectTree}) {
    EXPECT_GT(picture.ledger[part].calls, 0u) << scene::part_name(part);
  }
}

TEST(LeavingOut, WhatReflectsAloneHasNoRefractionListNoSharesAndPlainShadows) {
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 32, "height": 32},
    "materials": {"m": {"reflect": 0.5}},
    "objects": [{"name": "a", "material": "m", "plane": {"size": [4, 4]}}]})");
  const Picture picture = stage.draw();
  for (const Part part : {Part::kRefractions, Part::kShares, Part::kDimmedShadows})
    expect_nothing(picture.ledger, part);
  EXPECT_FALSE(stage.model.scene.has_dimmed_shadows);
  EXPECT_EQ(picture.statistics.refracted_rays, 0u);
  EXPECT_GT(picture.ledger[Part::kTrees].calls, 0u);
}

TEST(LeavingOut, WhatTransmitsShowsUp) {
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 32, "height": 32},
    "materials": {"m": {"transmit": 0.5}},
    "objects": [{"name": "a", "material": "m", "plane": {"size": [4, 4]}}]})");
  const Picture picture = stage.draw();
  for (const Part part : {Part::kTrees, Part::kRefractions, Part::kShares, Part::kDimmedShadows})
    EXPECT_GT(picture.ledger[part].calls, 0u) << scene::part_name(part);
}

TEST(LeavingOut, FootprintsFromOneSourceCostNothingOfTheOther) {
  Stage stage(R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 32, "height": 32},
    "textures": {"t": {"procedural": "checker"}}, "materials": {"m": {"texture": "t"}},
    "objects": [{"name": "a", "material": "m", "plane": {"size": [4, 4]}}]})");
  stage.set_texture(0, texmap::Image{4, 4, 1, std::vector<std::uint16_t>(16, 30000)});
  const Picture neighbours = stage.draw({.footprint = Footprint::kNeighbours});
  expect_nothing(neighbours.ledger, Part::kDifferentials);
  const Picture differentials =
      stage.draw({.footprint = Footprint::kDifferentials, .shadows = Shadows::kHard});
  expect_nothing(differentials.ledger, Part::kRows);
  expect_nothing(differentials.ledger, Part::kFilteredNodes);
  EXPECT_EQ(differentials.ledger[Part::kDifferentials].calls, differentials.statistics.textured_nodes);
  EXPECT_EQ(differentials.statistics.eye_rays, 32u * 32);
}

TEST(LeavingOut, RefinementCostsWhatIsRefined) {
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 32, "height": 32},
    "objects": [{"name": "torus", "sweep": {"contour": {"circle": {"radius": 0.5}}, "trajectory": {"circle": {"radius": 1.2}}}}]})");
  const Picture picture = stage.draw({.adaptive = Adaptive{}});
  EXPECT_GT(picture.ledger[Part::kRefinement].bytes, 0u);
  EXPECT_EQ(picture.ledger[Part::kRefinement].calls, picture.statistics.refined_pixels);
  EXPECT_GT(picture.statistics.refined_pixels, 0u);
  expect_nothing(picture.ledger, Part::kSupersampling);
}

// As scenes that need nothing of a kind: the same picture with it all switched on, and what it costs shows
// up.
class SwitchedOn : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(SwitchedOn, IsTheSamePictureAtAPrice) {
  const std::string scene =
      std::string(
          R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 48, "height": 48}, )") +
      GetParam().second + "}";
  for (const Options& options :
       {Options{}, Options{.filter = Filter::kPoint, .shadows = Shadows::kHard},
        Options{.footprint = Footprint::kDifferentials}, Options{.footprint = Footprint::kNeighbours},
        Options{.adaptive = Adaptive{}}, Options{.supersampling = 2}}) {
    const test::Drawn lean = test::draw(scene, options, true);
    const test::Drawn full = test::draw(scene, options, false);
    EXPECT_EQ(test::texels(lean.picture), test::texels(full.picture));
    for (std::size_t i = 0; i < scene::kPartCount; ++i) {
      const auto part = static_cast<Part>(i);
      EXPECT_GE(full.ledger[part].bytes, lean.ledger[part].bytes) << scene::part_name(part);
      if (!full.plan.needs_part(part) || lean.plan.needs_part(part)) continue;
      const scene::Cost& price = full.ledger[part];
      // Lists that stay empty are no call, but their memory is.
      EXPECT_GT(price.bytes + price.calls, 0u) << scene::part_name(part);
      EXPECT_EQ(lean.ledger[part].bytes + lean.ledger[part].calls, 0u) << scene::part_name(part);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, SwitchedOn,
    testing::Values(
        std::pair(
            "Plain",
            R"("objects": [{"name": "torus", "sweep": {"contour": {"circle": {"radius": 0.5}}, "trajectory": {"circle": {"radius": 1.2}}}}])"),
        std::pair(
            "Textured",
            R"("textures": {"t": {"procedural": "checker"}, "spare": {"procedural": "wood"}}, "materials": {"m": {"texture": "t"}},
          "objects": [{"name": "a", "material": "m", "plane": {"size": [4, 4]}}, {"name": "b", "translate": [0, 1, 0], "plane": {"size": [1, 1]}}])"),
        std::pair("Mirror", R"("materials": {"m": {"reflect": 0.5}},
          "objects": [{"name": "a", "material": "m", "plane": {"size": [4, 4]}}, {"name": "b", "translate": [0, 1, 0], "plane": {"size": [1, 1]}}])"),
        std::pair("Glass",
                  R"("materials": {"m": {"transmit": 0.8, "ior": 1.5, "fresnel": "exact", "reflect": 1}},
          "objects": [{"name": "a", "material": "m", "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}}, {"name": "b", "translate": [0, -1, 0], "plane": {"size": [4, 4]}}])"),
        std::pair("Ambient",
                  R"("ambient": [1, 1, 1], "objects": [{"name": "p", "plane": {"size": [1, 1]}}])")),
    [](const auto& scene) { return std::string(scene.param.first); });

}  // namespace
}  // namespace sweepkit::render
