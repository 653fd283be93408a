// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <set>

#include "parsed_gltf.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/levels.hpp"

namespace sweepkit::scene {
namespace {

// A ball of radius 1, divided finely.
const std::string kBall =
    R"({"name": "ball", "material": "m", "tessellation": {"contour": 200, "trajectory": 400},
        "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}})";

struct Made {
  Document document;
  Plan plan;
  Model model;
};

Made made(const std::string& text, int levels) {
  Made made{.document = parse(text), .plan = {}, .model = {}};
  made.plan = plan(made.document, {.product = Request::Product::kMeshFile});
  made.model = build(made.document, made.plan);
  if (levels > 0) add_levels(made.model, made.document, made.plan, levels);
  return made;
}

json gltf_of(const Made& made, const GltfOptions& options = {.bake_size = 16}) {
  const GltfFile file = make_gltf(made.model.scene, made.plan, "a.gltf", options);
  const auto* text = reinterpret_cast<const char*>(file.files.back().bytes.data());
  return json::parse(text, text + file.files.back().bytes.size());
}

std::string scene_with(const std::string& objects, const std::string& material = "{}") {
  return scene_text(R"("materials": {"m": )" + material + "}", objects);
}

TEST(Levels, AreWithinAPixelOfTheBallAtTheHeightTheyAreFor) {
  const Made ball = made(scene_with(kBall), 5);
  const std::vector<CoarserMesh>& levels = ball.model.scene.coarser.at(0);
  ASSERT_EQ(levels.size(), 5u);
  const double diagonal = 2 * std::sqrt(3.0);
  for (const CoarserMesh& level : levels) {
    const double pixel = diagonal / (kLevelHeight * level.height);
    double most = 0;
    const MeshView& mesh = ball.model.scene.meshes[level.mesh];
    for (const sweep::Triangle& triangle : mesh.triangles) {
      const glm::dvec3 a(mesh.positions[triangle[0]]);
      const glm::dvec3 b(mesh.positions[triangle[1]]);
      const glm::dvec3 c(mesh.positions[triangle[2]]);
      // The plane's distance from the middle is the least that any of the triangle's points can have.
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      if (glm::length(normal) > 0)
        most = std::max(most, 1 - std::abs(glm::dot(a + mesh.origin, glm::normalize(normal))));
    }
    EXPECT_LE(most, pixel + 1e-6) << "float32 positions round by 6e-8";
    EXPECT_GT(most, 0.1 * pixel) << "finer than it need be";
  }
}

TEST(Levels, EachHasAtMostTwoThirdsOfTheTrianglesOfTheOneBefore) {
  const Made ball = made(scene_with(kBall), 8);
  std::size_t finer = ball.model.scene.meshes[0].triangles.size();
  double height = 1;
  ASSERT_GE(ball.model.scene.coarser.at(0).size(), 5u);
  for (const CoarserMesh& level : ball.model.scene.coarser.at(0)) {
    const std::size_t triangles = ball.model.scene.meshes[level.mesh].triangles.size();
    EXPECT_LE(3 * triangles, 2 * finer);
    EXPECT_LT(level.height, height);
    finer = triangles;
    height = level.height;
  }
}

TEST(Levels, AMeshThatIsCoarseAlreadyHasNone) {
  const Made box = made(
      scene_with(
          R"({"name": "a", "sweep": {"contour": {"polyline": [[0, 0], [1, 0], [1, 1], [0, 1]], "closed": true}, "trajectory": {"line": [[0, 0, 0], [0, 0, 1]]}},
              "tessellation": {"tolerance": 0.001}})"),
      4);
  EXPECT_TRUE(box.model.scene.coarser.at(0).empty());
  const Made floor =
      made(scene_text("", R"({"name": "f", "plane": {"size": [1, 1]}, "tessellation": {"contour": 99}})"), 4);
  EXPECT_TRUE(floor.model.scene.coarser.at(0).empty());
  EXPECT_EQ(floor.model.meshes.size(), 1u);
}

TEST(Levels, OfAScaledPartAreAsCloseInTheObject) {
  const std::string part = kBall.substr(kBall.find("\"tessellation\""));
  const Made ball = made(scene_with(R"({"name": "a", "parts": [{"scale": 10, )" + part + "]}"), 2);
  ASSERT_EQ(ball.model.scene.coarser.at(0).size(), 2u);
  for (const CoarserMesh& level : ball.model.scene.coarser.at(0)) {
    EXPECT_LE(*ball.model.meshes[level.mesh]->deviation,
              20 * std::sqrt(3.0) / (kLevelHeight * level.height) * (1 + 1e-6));
  }
}

TEST(GltfLevels, TheFinestIsWhatAPlainFileHas) {
  const json plain = gltf_of(made(scene_with(kBall), 0));
  const json levels = gltf_of(made(scene_with(kBall), 3));
  EXPECT_EQ(plain["meshes"][0], levels["meshes"][0]);
  EXPECT_EQ(plain["scenes"][0]["nodes"].size(), levels["scenes"][0]["nodes"].size());
  EXPECT_EQ(plain["materials"], levels["materials"]);
  for (const char* member : {"mesh", "name"})
    EXPECT_EQ(plain["nodes"][0][member], levels["nodes"][0][member]);
}

TEST(GltfLevels, TheFinestPointsAtTheOthersWhichNothingElsePointsAt) {
  const json root = gltf_of(made(scene_with(kBall + "," + kFloor), 3));
  const json& node = root["nodes"][0];
  const std::vector<int> ids = node["extensions"]["MSFT_lod"]["ids"];
  EXPECT_EQ(ids, (std::vector<int>{1, 2, 3}));
  const std::vector<double> shares = node["extras"]["MSFT_screencoverage"];
  ASSERT_EQ(shares.size(), 4u);
  // A ball half as high as a picture of 16:9 covers pi / 4 / 4 * 9 / 16 of it.
  EXPECT_NEAR(shares[0], std::acos(-1.0) / 16 * 9 / 16, 1e-7);
  EXPECT_NEAR(shares[1], shares[0] / 4, 1e-7);
  EXPECT_EQ(shares[3], 0);
  EXPECT_EQ(root["scenes"][0]["nodes"][0], 0);
  for (const json& one : root["scenes"][0]["nodes"]) {
    for (const int id : ids) EXPECT_NE(one, id);
  }
  EXPECT_FALSE(root["nodes"][4].contains("extensions")) << "the floor";
  const std::set<std::string> used = root["extensionsUsed"];
  EXPECT_TRUE(used.contains("MSFT_lod"));
  EXPECT_FALSE(root.contains("extensionsRequired"));
}

TEST(GltfLevels, EachInstanceHasNodesOfItsOwnAndTheMeshesAreShared) {
  const std::string two = kBall.substr(0, kBall.size() - 1) +
                          R"(, "instances": [{"translate": [3, 0, 0]}, {"translate": [6, 0, 0]}]})";
  const json root = gltf_of(made(scene_with(two), 2));
  EXPECT_EQ(root["meshes"].size(), 3u);
  const std::vector<int> children = root["nodes"][0]["children"];
  EXPECT_EQ(children, (std::vector<int>{1, 4}));
  for (const int child : children) {
    for (const int id : root["nodes"][child]["extensions"]["MSFT_lod"]["ids"]) {
      EXPECT_EQ(root["nodes"][id]["translation"], root["nodes"][child]["translation"]);
    }
  }
}

TEST(GltfLevels, QuantizedGlassIsAsThickInEveryLevel) {
  const json root =
      gltf_of(made(scene_with(kBall, R"({"transmit": 1, "ior": 1.5, "diffuse": [0, 0, 0]})"), 3),
              {.is_quantized = true});
  for (std::size_t i = 0; i < 4; ++i) {
    const json& node = root["nodes"][i];
    const json& material =
        root["materials"]
            [root["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0]["material"].get<std::size_t>()];
    const double thickness = material["extensions"]["KHR_materials_volume"]["thicknessFactor"];
    // The finest mesh's own 4 V / S: chords of 0.9 degrees are off by 3e-5 of the radius, quantizing by 2e-5.
    EXPECT_NEAR(thickness * node["scale"][0].get<double>(), 4.0 / 3, 1e-4) << "4 V / S of the ball";
  }
}

TEST(GltfLevels, ColoursBakedOverTheMeshAreOneImageForAllLevels) {
  const json root = gltf_of(
      made(scene_text(R"("textures": {"t": {"procedural": "marble"}}, "materials": {"m": {"texture": "t"}})",
                      kBall),
           3));
  EXPECT_EQ(root["images"].size(), 1u);
  EXPECT_EQ(root["materials"].size(), 1u);
  EXPECT_EQ(root["meshes"].size(), 4u);
}

TEST(GltfLevels, DoNotGrow) {
  const Made ball = made(scene_with(kBall), 1);
  EXPECT_THROW(gltf_of(ball, {.grow_seconds = 1}), InputError);
}

}  // namespace
}  // namespace sweepkit::scene
