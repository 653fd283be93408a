// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "sweepkit/scene/plan.hpp"

#include <gtest/gtest.h>

#include <set>

#include "scene_text.hpp"

namespace sweepkit::scene {
namespace {

using Product = Request::Product;
constexpr Request kPicture{.product = Product::kPicture, .filter = texmap::Filter::kIntegral1};
constexpr Request kFile{.product = Product::kMeshFile};

std::set<Part> needed(const Document& document, const Request& request) {
  const Plan plan = scene::plan(document, request);
  std::set<Part> parts;
  for (std::size_t i = 0; i < kPartCount; ++i) {
    EXPECT_FALSE(plan.needs[i].why.empty()) << part_name(static_cast<Part>(i));
    if (plan.needs[i].is_needed) parts.insert(static_cast<Part>(i));
  }
  return parts;
}

// One plane with a material of `material`; the textures are an image, tiles on (u,v) and marble on position.
Document scene_of(const std::string& material, const std::string& beside = R"("ambient": [1, 1, 1])") {
  return parse(scene_text(beside +
                              R"(, "textures": {"image": {"image": "x.png"}, "tiles": {"procedural": "tiles"},
                             "marble": {"procedural": "marble", "on": "position"}}, "materials": {"m": {)" +
                              material + "}}",
                          R"({"name": "a", "material": "m", "plane": {"size": [1, 1]}})"));
}

TEST(Plan, APlainSceneNeedsNothing) {
  EXPECT_EQ(needed(scene_of(""), kPicture), std::set<Part>{});
  EXPECT_EQ(needed(scene_of(""), kFile), std::set<Part>{});
}

TEST(Plan, AFileThatCannotHoldTexturesNeedsNone) {
  const Document textured = scene_of(R"("texture": "marble")");
  EXPECT_EQ(needed(textured, kFile), (std::set{Part::kTextures, Part::kBakes}));
  Request plain = kFile;
  plain.has_textures = false;
  EXPECT_EQ(needed(textured, plain), std::set<Part>{});
  EXPECT_EQ(plan(textured, plain).textures, (std::vector{false, false, false}));

  const Document mesh = parse(scene_text("", R"({"name": "m", "mesh": {"file": "m.obj"}})"));
  EXPECT_EQ(needed(mesh, plain), std::set{Part::kLayouts});
  plain.has_texcoords = false;
  EXPECT_EQ(needed(mesh, plain), std::set<Part>{});
}

TEST(Plan, AnImageThatIsFilteredNeedsTablesRowsAndTexcoords) {
  EXPECT_EQ(needed(scene_of(R"("texture": "image")"), kPicture),
            (std::set{Part::kTextures, Part::kTables, Part::kTexcoords, Part::kFilteredNodes,
                      Part::kDifferentials, Part::kRows}));
}

TEST(Plan, EveryFilterNeedsWhatItReadsAlone) {
  const Document document = scene_of(R"("texture": "image")");
  const auto with = [&](texmap::Filter filter) {
    return needed(document, {.product = Product::kPicture, .filter = filter});
  };
  for (const texmap::Filter filter :
       {texmap::Filter::kIntegral1, texmap::Filter::kIntegral2, texmap::Filter::kIntegral3}) {
    EXPECT_EQ(with(filter), (std::set{Part::kTextures, Part::kTables, Part::kTexcoords, Part::kFilteredNodes,
                                      Part::kDifferentials, Part::kRows}));
  }
  EXPECT_EQ(with(texmap::Filter::kBilinear), (std::set{Part::kTextures, Part::kTiles, Part::kTexcoords}));
  for (const texmap::Filter filter :
       {texmap::Filter::kTrilinear, texmap::Filter::kEwa, texmap::Filter::kBox, texmap::Filter::kAuto}) {
    EXPECT_EQ(with(filter), (std::set{Part::kTextures, Part::kTiles, Part::kTexcoords, Part::kFilteredNodes,
                                      Part::kDifferentials, Part::kRows}));
  }
}

TEST(Plan, FootprintsNeedTheSourceTheyAreAskedFrom) {
  const Document document = scene_of(R"("texture": "image")");
  Request request{.product = Product::kPicture, .filter = texmap::Filter::kEwa, .has_differentials = false};
  EXPECT_EQ(needed(document, request),
            (std::set{Part::kTextures, Part::kTiles, Part::kTexcoords, Part::kFilteredNodes, Part::kRows}));
  request.has_neighbours = false;
  request.has_differentials = true;
  EXPECT_EQ(needed(document, request),
            (std::set{Part::kTextures, Part::kTiles, Part::kTexcoords, Part::kDifferentials}));
  request.filter = texmap::Filter::kPoint;
  EXPECT_EQ(needed(document, request), (std::set{Part::kTextures, Part::kTiles, Part::kTexcoords}));
}

TEST(Plan, AnImageThatIsNotFilteredNeedsItsTilesAndTexcoords) {
  EXPECT_EQ(needed(scene_of(R"("texture": "image")"), {.product = Product::kPicture}),
            (std::set{Part::kTextures, Part::kTiles, Part::kTexcoords}));
}

TEST(Plan, ProceduralTexturesNeedRowsButNoTable) {
  for (const texmap::Filter filter :
       {texmap::Filter::kBilinear, texmap::Filter::kTrilinear, texmap::Filter::kIntegral1,
        texmap::Filter::kEwa, texmap::Filter::kAuto}) {
    const Request request{.product = Product::kPicture, .filter = filter};
    EXPECT_EQ(needed(scene_of(R"("texture": "tiles")"), request),
              (std::set{Part::kTextures, Part::kTexcoords, Part::kFilteredNodes, Part::kDifferentials,
                        Part::kRows}));
    EXPECT_EQ(needed(scene_of(R"("texture": "marble")"), request),
              (std::set{Part::kTextures, Part::kFilteredNodes, Part::kDifferentials, Part::kRows}));
  }
}

TEST(Plan, ProceduralTexturesAtPointsNeedNoRows) {
  const Request request{.product = Product::kPicture, .filter = texmap::Filter::kPoint};
  EXPECT_EQ(needed(scene_of(R"("texture": "tiles")"), request),
            (std::set{Part::kTextures, Part::kTexcoords}));
  EXPECT_EQ(needed(scene_of(R"("texture": "marble")"), request), std::set{Part::kTextures});
}

TEST(Plan, AFileNeedsTexturesAndBakesButNothingOfAPicture) {
  EXPECT_EQ(needed(scene_of(R"("texture": "image", "reflect": 0.5)"), kFile), std::set{Part::kTextures});
  EXPECT_EQ(needed(scene_of(R"("texture": "marble")"), kFile), (std::set{Part::kTextures, Part::kBakes}));
}

TEST(Plan, ABakeNeedsABake) {
  EXPECT_EQ(needed(scene_of(R"("texture": "marble")"), {.product = Product::kTexture}),
            (std::set{Part::kTextures, Part::kBakes}));
}

TEST(Plan, TreesNeedAReflectionAndADepth) {
  EXPECT_EQ(needed(scene_of(R"("reflect": 0.5)"), kPicture), std::set{Part::kTrees});
  EXPECT_EQ(needed(scene_of(R"("reflect": 0.5)", R"("ambient": [1, 1, 1], "depth": 0)"), kPicture),
            std::set<Part>{});
}

TEST(Plan, RefractionsNeedWhatTransmitsAndADepth) {
  EXPECT_EQ(needed(scene_of(R"("transmit": 0.5)"), kPicture),
            (std::set{Part::kTrees, Part::kRefractions, Part::kShares}));
  EXPECT_EQ(needed(scene_of(R"("transmit": 0.5)", R"("ambient": [1, 1, 1], "depth": 0)"), kPicture),
            std::set<Part>{});
}

TEST(Plan, SharesAtNodesNeedAnAngleThatTheyDependOn) {
  EXPECT_EQ(needed(scene_of(R"("reflect": 0.5, "ior": 1.5, "fresnel": "exact")"), kPicture),
            (std::set{Part::kTrees, Part::kShares}));
  EXPECT_EQ(needed(scene_of(R"("ior": 1.5, "fresnel": "exact")"), kPicture), std::set<Part>{});
}

TEST(Plan, DimmedShadowsNeedALightAndWhatTransmits) {
  const Document lit = scene_of(R"("transmit": 0.5)", R"("lights": [{"point": [0, 1, 0]}], "depth": 0)");
  EXPECT_EQ(needed(lit, kPicture), (std::set{Part::kShadows, Part::kDimmedShadows}));
}

TEST(Plan, ThicknessesNeedGlassAndAFileThatTellsThem) {
  const Document glass = scene_of(R"("transmit": 0.5)", R"("lights": [{"point": [0, 1, 0]}], "depth": 0)");
  EXPECT_EQ(needed(glass, kFile), std::set{Part::kThicknesses});
  EXPECT_EQ(needed(glass, {.product = Product::kMeshFile, .has_thicknesses = false}), std::set<Part>{});
  EXPECT_EQ(needed(scene_of(R"("reflect": 0.5)"), kFile), std::set<Part>{});
}

TEST(Plan, ANormalMapNeedsTangentsAndItsImageButNoFootprintsFromNeighbours) {
  const Document document = scene_of(R"("normal_map": "image")");
  EXPECT_EQ(needed(document, kPicture), (std::set{Part::kTextures, Part::kTables, Part::kNormalMaps}));
  EXPECT_EQ(plan(document, kPicture).sampled, (std::vector{true, false, false}));
  EXPECT_EQ(needed(document, kFile), (std::set{Part::kTextures, Part::kNormalMaps}));
  EXPECT_EQ(needed(document, {.product = Product::kMeshFile, .has_tangents = false}),
            std::set{Part::kTextures});
  EXPECT_EQ(needed(document, {.product = Product::kMeshFile, .has_normal_maps = false}), std::set<Part>{});
  const Document mesh = parse(scene_text(
      R"("ambient": [1, 1, 1], "textures": {"i": {"image": "x.png"}}, "materials": {"m": {"normal_map": "i"}})",
      R"({"name": "m", "material": "m", "mesh": {"file": "m.obj"}})"));
  EXPECT_EQ(needed(mesh, {.product = Product::kPicture}),
            (std::set{Part::kLayouts, Part::kTextures, Part::kTiles, Part::kNormalMaps}));
}

TEST(Plan, ABackgroundImageIsForPicturesAlone) {
  const Document document = scene_of("", R"("ambient": [1, 1, 1], "background": {"image": "sky.exr"})");
  EXPECT_EQ(needed(document, kPicture), std::set{Part::kEnvironment});
  EXPECT_EQ(needed(document, kFile), std::set<Part>{});
}

TEST(Plan, ShadowsNeedALightAndTheDefaultLightIsOne) {
  EXPECT_EQ(needed(scene_of("", R"("lights": [{"point": [0, 1, 0]}])"), kPicture), std::set{Part::kShadows});
  EXPECT_EQ(needed(parse(scene_text("")), kPicture), std::set{Part::kShadows});
  EXPECT_EQ(needed(parse(scene_text(R"("lights": [])")), kPicture), std::set{Part::kShadows});
}

TEST(Plan, SmoothShadowsNeedALightAndTheRowsAboveAndBelow) {
  Request request = kPicture;
  request.has_smooth_shadows = true;
  EXPECT_EQ(needed(scene_of("", R"("lights": [{"point": [0, 1, 0]}])"), request),
            (std::set{Part::kShadows, Part::kShadowEdges, Part::kRows}));
  EXPECT_EQ(needed(scene_of(""), request), std::set<Part>{});
  request.product = Product::kMeshFile;
  EXPECT_EQ(needed(scene_of("", R"("lights": [{"point": [0, 1, 0]}])"), request), std::set<Part>{});
}

TEST(Plan, AnErrorEstimateIsThereWhenAskedForAndFiltersByDifferentials) {
  Request request{.product = Product::kPicture,
                  .filter = texmap::Filter::kEwa,
                  .estimates_error = true,
                  .has_neighbours = true,
                  .has_differentials = false};
  EXPECT_EQ(needed(scene_of(""), request), std::set{Part::kErrorEstimate});
  EXPECT_EQ(needed(scene_of(R"("texture": "image")"), request),
            (std::set{Part::kTextures, Part::kTiles, Part::kTexcoords, Part::kFilteredNodes,
                      Part::kDifferentials, Part::kRows, Part::kErrorEstimate}));
  request.product = Product::kMeshFile;
  EXPECT_EQ(needed(scene_of(""), request), std::set<Part>{});
}

TEST(Plan, RefinementIsThereWhenAskedForAndFiltersByDifferentials) {
  Request request{.product = Product::kPicture,
                  .filter = texmap::Filter::kEwa,
                  .is_refined = true,
                  .has_differentials = false};
  EXPECT_EQ(needed(scene_of(""), request), std::set{Part::kRefinement});
  EXPECT_EQ(needed(scene_of(R"("texture": "image")"), request),
            (std::set{Part::kTextures, Part::kTiles, Part::kTexcoords, Part::kFilteredNodes,
                      Part::kDifferentials, Part::kRows, Part::kRefinement}));
}

TEST(Plan, SupersamplingAndHalfEdgesAreThereWhenAskedFor) {
  EXPECT_EQ(needed(scene_of(""), {.product = Product::kPicture, .is_supersampled = true}),
            std::set{Part::kSupersampling});
  EXPECT_EQ(needed(scene_of(""), {.product = Product::kMeshFile, .has_half_edges = true}),
            std::set{Part::kHalfEdges});
}

TEST(Plan, LayersAreThereWhenAskedForAndOneOfTexcoordsLaysMeshFilesOut) {
  EXPECT_EQ(needed(scene_of(""), {.product = Product::kPicture, .has_layers = true}),
            std::set{Part::kLayers});
  EXPECT_EQ(needed(scene_of(""), {.product = Product::kMeshFile, .has_layers = true}), std::set<Part>{});
  const Document mesh = parse(
      R"({"sweepkit": 1, "ambient": [1, 1, 1], "objects": [{"name": "m", "mesh": {"file": "m.obj"}}]})");
  EXPECT_EQ(needed(mesh, kPicture), std::set<Part>{});
  EXPECT_EQ(needed(mesh, {.product = Product::kPicture, .has_layers = true, .shows_texcoords = true}),
            (std::set{Part::kLayers, Part::kLayouts}));
}

TEST(Plan, TheTreeOverObjectsNeedsTwoOrTwoInstances) {
  const Document two =
      parse(scene_text(R"("ambient": [1, 1, 1])", kFloor + R"(, {"name": "b", "plane": {"size": [1, 1]}})"));
  EXPECT_EQ(needed(two, kPicture), std::set{Part::kObjectTree});
  EXPECT_EQ(needed(two, kFile), std::set<Part>{});
  const auto instanced = [](const std::string& instances) {
    return parse(scene_text(R"("ambient": [1, 1, 1])",
                            R"({"name": "a", "plane": {"size": [1, 1]}, "instances": )" + instances + "}"));
  };
  EXPECT_EQ(needed(instanced("[{}, {}]"), kPicture), std::set{Part::kObjectTree});
  EXPECT_EQ(needed(instanced("[{}]"), kPicture), std::set<Part>{});
}

TEST(Plan, MaterialsThatNoObjectHasCountForNothing) {
  const Document document = parse(scene_text(
      R"("ambient": [1, 1, 1], "textures": {"t": {"image": "x.png"}}, "materials": {"m": {"texture": "t", "reflect": 1}})"));
  EXPECT_EQ(needed(document, kPicture), std::set<Part>{});
  EXPECT_EQ(plan(document, kPicture).textures, std::vector{false});
}

TEST(Plan, SamplersAreForTheImagesInUse) {
  const Plan plan = scene::plan(scene_of(R"("texture": "image")"), kPicture);
  EXPECT_EQ(plan.textures, (std::vector{true, false, false}));
  EXPECT_EQ(plan.sampled, (std::vector{true, false, false}));
  EXPECT_EQ(scene::plan(scene_of(R"("texture": "tiles")"), kPicture).sampled,
            (std::vector{false, false, false}));
}

TEST(Plan, PartsHaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kPartCount; ++i) names.insert(part_name(static_cast<Part>(i)));
  EXPECT_EQ(names.size(), kPartCount);
  EXPECT_EQ(names.count(""), 0u);
}

TEST(Ledger, AddsBytesAndCalls) {
  Ledger a;
  a[Part::kTables] = {10, 1};
  Ledger b;
  b[Part::kTables] = {5, 2};
  b[Part::kRows] = {std::uint64_t{1} << 40, 3};
  a.add(b);
  EXPECT_EQ(a[Part::kTables].bytes, 15u);
  EXPECT_EQ(a[Part::kTables].calls, 3u);
  EXPECT_EQ(a[Part::kRows].bytes, std::uint64_t{1} << 40);
  EXPECT_EQ(a[Part::kTrees].calls, 0u);
}

}  // namespace
}  // namespace sweepkit::scene
