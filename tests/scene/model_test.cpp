// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "sweepkit/scene/model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "scene_text.hpp"

namespace sweepkit::scene {
namespace {

constexpr Request kFile{.product = Request::Product::kMeshFile};

Model build_text(const std::string& text, const Request& request = kFile) {
  const Document document = parse(text);
  return build(document, plan(document, request));
}

std::string build_fault(const std::string& text) {
  try {
    build_text(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Where a point stands in the picture: -1 to 1 each way inside it.
glm::dvec2 in_picture(const Scene& scene, const glm::dvec3& point) {
  const glm::dvec3 seen = glm::transpose(world_from_camera(scene.camera)) * (point - scene.camera.eye);
  const double half = std::tan(0.5 * scene.camera.fov_deg * std::numbers::pi / 180);
  return glm::dvec2(seen.x * scene.height / scene.width, seen.y) / (-seen.z * half);
}

const std::string kTube =
    R"({"name": "tube", "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0, 0, 0], [0, 1, 0]]}, "caps": "none"}})";

TEST(Model, ThePapersVaseAndCupHaveThePapersTriangles) {
  const Document document = read_document(SWEEPKIT_SAMPLES "/scenes/vase_and_cup.json");
  const Model model = build(document, plan(document, kFile));
  std::map<std::string, std::size_t> triangles;
  for (const Object& object : model.scene.objects) {
    triangles[object.name] = model.scene.meshes[object.mesh].triangles.size();
  }
  EXPECT_EQ(triangles["vase"], 7200u);
  EXPECT_EQ(triangles["cup"], 8400u);
}

TEST(Model, ViewsLookAtTheMeshesOwnArraysAndSurviveAMove) {
  Model model = build_text(scene_text("", kTube));
  const Model moved = std::move(model);
  const MeshView& view = moved.scene.meshes[0];
  const sweep::Mesh& mesh = *moved.meshes[0];
  EXPECT_EQ(view.positions.data(), mesh.positions().data());
  EXPECT_EQ(view.normals.data(), mesh.normals().data());
  EXPECT_EQ(view.texcoords.data(), mesh.texcoords().data());
  EXPECT_EQ(view.triangles.data(), mesh.triangles.data());
  EXPECT_EQ(view.patches.size(), mesh.patches.size());
  EXPECT_EQ(view.areas.size(), mesh.areas.size());
}

TEST(Model, WithoutATessellationAShapeHasItsOwn) {
  EXPECT_EQ(build_text(scene_text("", kTube)).scene.meshes[0].triangles.size(), 2u * 64 * 64);
  EXPECT_EQ(build_text(scene_text("")).scene.meshes[0].triangles.size(), 2u);
}

TEST(Model, HalfEdgesAreThereOnlyWhenAskedFor) {
  const Model without = build_text(scene_text("", kTube));
  EXPECT_EQ(without.meshes[0]->n_faces(), 0u);
  EXPECT_EQ(without.ledger[Part::kHalfEdges].bytes, 0u);
  EXPECT_EQ(without.ledger[Part::kHalfEdges].calls, 0u);
  const Model with =
      build_text(scene_text("", kTube), {.product = Request::Product::kMeshFile, .has_half_edges = true});
  EXPECT_EQ(with.meshes[0]->n_faces(), with.scene.meshes[0].triangles.size());
  EXPECT_GT(with.ledger[Part::kHalfEdges].bytes, 0u);
  EXPECT_EQ(with.ledger[Part::kHalfEdges].calls, 1u);
}

TEST(Model, PartsBecomeOneMeshEachByItsOwnPlacement) {
  const Model model = build_text(scene_text("", R"({"name": "set", "translate": [0, 10, 0], "parts": [
    {"plane": {"size": [2, 2]}, "translate": [5, 0, 0]},
    {"plane": {"size": [2, 2]}, "translate": [0, 0, 7], "rotate_deg": [0, 0, 90], "scale": [1, 1, 3]}]})"));
  ASSERT_EQ(model.scene.meshes.size(), 1u);
  const MeshView& mesh = model.scene.meshes[0];
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.areas.size(), 2u);
  EXPECT_EQ(mesh.patches.size(), 2u);
  ASSERT_EQ(mesh.positions.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec3 position = glm::dvec3(mesh.positions[i]) + mesh.origin;
    if (i < 4) {
      EXPECT_EQ(std::abs(position.x - 5), 1) << i;
      EXPECT_EQ(mesh.normals[i], glm::vec3(0, 1, 0));
    } else {
      EXPECT_EQ(position.x, 0) << "turned upright, to the last bit";
      EXPECT_EQ(std::abs(position.z - 7), 3);
      EXPECT_EQ(mesh.normals[i], glm::vec3(-1, 0, 0));
    }
  }
  EXPECT_EQ(glm::dvec3(model.scene.objects[0].world_from_object[3]), glm::dvec3(0, 10, 0));
}

TEST(Model, APartThatIsTheOnlyOneIsPlacedToo) {
  const Model model = build_text(
      scene_text("", R"({"name": "a", "parts": [{"plane": {"size": [2, 2]}, "translate": [5, 0, 0]}]})"));
  const MeshView& mesh = model.scene.meshes[0];
  EXPECT_EQ(std::abs(mesh.positions[0].x + mesh.origin.x - 5), 1);
}

// Drawn once for each instance, moved from where the object stands, and not by itself.
TEST(Model, InstancesShareAMeshAndMoveThePlacedObject) {
  const Model model =
      build_text(scene_text("", R"({"name": "a", "plane": {"size": [1, 1]}, "translate": [1, 0, 0],
    "instances": [{"rotate_deg": [0, 90, 0]}, {"translate": [0, 2, 0], "scale": 3}]}, {"name": "b", "plane": {"size": [1, 1]}})"));
  ASSERT_EQ(model.meshes.size(), 2u);
  const std::vector<Object>& objects = model.scene.objects;
  ASSERT_EQ(objects.size(), 3u);
  EXPECT_EQ(objects[0].name, "a");
  EXPECT_EQ(objects[1].name, "a");
  EXPECT_EQ(objects[1].mesh, objects[0].mesh);
  EXPECT_EQ(objects[1].instance, 1u);
  EXPECT_EQ(objects[0].world_from_object * glm::dvec4(0, 0, 0, 1), glm::dvec4(0, 0, -1, 1));
  EXPECT_EQ(objects[1].world_from_object * glm::dvec4(1, 0, 0, 1), glm::dvec4(6, 2, 0, 1));
  EXPECT_EQ(objects[2].mesh, 1u);
  EXPECT_EQ(objects[2].instance, 0u);
}

TEST(Model, WithoutACameraThePictureHoldsAllInstances) {
  const Model model =
      build_text(scene_text("", R"({"name": "a", "plane": {"size": [1, 1]}, "rotate_deg": [30, 10, 0],
    "instances": [{}, {"translate": [50, 0, 0]}, {"translate": [0, 0, -20], "rotate_deg": [0, 40, 5]}]})"));
  for (const Object& object : model.scene.objects) {
    for (const glm::vec3& position : model.scene.meshes[0].positions) {
      const glm::dvec3 at = glm::dvec3(position) + model.scene.meshes[0].origin;
      const glm::dvec2 seen =
          in_picture(model.scene, glm::dvec3(object.world_from_object * glm::dvec4(at, 1)));
      EXPECT_LT(std::max(std::abs(seen.x), std::abs(seen.y)), 1);
    }
  }
}

TEST(Model, FaultsOfTheGeometryHaveThePlaceOfTheShape) {
  const auto expect_at = [](const std::string& text, const std::string& place) {
    const std::string message = build_fault(text);
    EXPECT_EQ(message.rfind(place, 0), 0u) << message;
    EXPECT_NE(message.find("crosses the axis"), std::string::npos) << message;
  };
  const std::string crossing = R"("revolve": {"contour": {"line": [[-1, 0], [1, 1]]}})";
  expect_at(scene_text("", "\n{\"name\": \"a\", " + crossing + "}"),
            "folder/s.json:2:26: /objects/0/revolve: ");
  expect_at(
      scene_text("", "{\"name\": \"a\", \"parts\": [{\"plane\": {\"size\": [1, 1]}},\n{" + crossing + "}]}"),
      "folder/s.json:2:13: /objects/0/parts/1/revolve: ");
}

TEST(Model, TexturesThatCannotBeReadAreToldWithFileAndPlace) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "sweepkit_no_image.png";
  std::ofstream(file) << "this is no picture";
  const auto scene = [](const std::string& image) {
    return scene_text("\"textures\": {\"t\":\n{\"image\": \"" + image +
                          "\"}}, \"materials\": {\"m\": {\"texture\": \"t\"}}",
                      R"({"name": "a", "material": "m", "plane": {"size": [1, 1]}})");
  };
  EXPECT_EQ(build_fault(scene("none.png")),
            "folder/s.json:2:11: /textures/t/image: folder/none.png: no such file");
  const std::string message = build_fault(scene(file.string()));
  EXPECT_EQ(
      message.rfind(
          "folder/s.json:2:11: /textures/t/image: " + file.string() + ": cannot be read as an image", 0),
      0u)
      << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  std::filesystem::remove(file);
}

TEST(Model, ABackgroundThatCannotBeReadIsToldWithFileAndPlaceAndReadForPicturesAlone) {
  const Document document = parse(scene_text(R"("background": {"image": "none.exr"})"));
  try {
    build(document, plan(document, {.product = Request::Product::kPicture}));
    ADD_FAILURE() << "it was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place().pointer, "/background/image");
    EXPECT_NE(std::string(error.what()).find("folder/none.exr"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(build(document, plan(document, {.product = Request::Product::kMeshFile})).scene.environment);
}

TEST(Model, TexturesThatNothingUsesAreNotRead) {
  const Model model = build_text(scene_text(
      R"("textures": {"t": {"image": "not there.png"}}, "materials": {"unused": {"texture": "t"}})"));
  EXPECT_EQ(std::get<texmap::ImageTexture>(model.scene.textures[0]).image, nullptr);
  EXPECT_EQ(model.ledger[Part::kTextures].calls, 0u);
  EXPECT_EQ(model.ledger[Part::kTextures].bytes, 0u);
}

TEST(Model, TexturesInUseAreReadAndCounted) {
  const Document document = read_document(SWEEPKIT_SAMPLES "/scenes/vase_and_cup.json");
  const Model model = build(document, plan(document, kFile));
  std::uint64_t bytes = 0;
  for (const texmap::Texture& texture : model.scene.textures)
    bytes += std::get<texmap::ImageTexture>(texture).image->bytes();
  EXPECT_EQ(model.ledger[Part::kTextures].calls, model.scene.textures.size());
  EXPECT_EQ(model.ledger[Part::kTextures].bytes, bytes);
}

TEST(Model, WithoutACameraThePictureFramesTheScene) {
  for (const char* camera : {R"("camera": {})", R"("camera": {"width": 400, "height": 100})",
                             R"("camera": {"width": 100, "height": 400, "fov_deg": 80})"}) {
    const Model model = build_text(
        scene_text(camera, R"({"name": "bar", "plane": {"size": [7, 0.5]}, "translate": [100, 0, -3]})"));
    const double narrow = std::min(model.scene.width, model.scene.height);
    double widest = 0;
    double longest = 0;  // in halves of the picture's narrow side
    for (const glm::vec3& position : model.scene.meshes[0].positions) {
      const glm::dvec3 world(model.scene.objects[0].world_from_object *
                             glm::dvec4(glm::dvec3(position) + model.scene.meshes[0].origin, 1));
      const glm::dvec2 at = in_picture(model.scene, world);
      widest = std::max({widest, std::abs(at.x), std::abs(at.y)});
      longest =
          std::max(longest, glm::length(at * glm::dvec2(model.scene.width, model.scene.height) / narrow));
    }
    EXPECT_LT(widest, 1) << camera;
    EXPECT_GT(longest, 0.6) << camera << ": the bar nearly fills the sphere that is framed";
  }
}

TEST(Model, AGivenCameraIsKept) {
  const Model model = build_text(scene_text(R"("camera": {"eye": [1, 2, 3], "target": [4, 5, 6]})"));
  EXPECT_EQ(model.scene.camera.eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(model.scene.camera.target, glm::dvec3(4, 5, 6));
}

TEST(Model, ALightIsAddedOnlyWhereLightsAndAmbientAreBothAbsent) {
  const Model dark = build_text(scene_text(""));
  ASSERT_EQ(dark.scene.lights.size(), 1u);
  const glm::dvec3 direction = std::get<DirectionalLight>(dark.scene.lights[0]).direction;
  EXPECT_GT(glm::dot(direction, dark.scene.camera.target - dark.scene.camera.eye), 0)
      << "from behind the viewer";
  EXPECT_LT(direction.y, 0) << "from above";
  EXPECT_TRUE(build_text(scene_text(R"("ambient": [0, 0, 0])")).scene.lights.empty());
  EXPECT_EQ(build_text(scene_text(R"("lights": [{"point": [0, 1, 0]}])")).scene.lights.size(), 1u);
}

}  // namespace
}  // namespace sweepkit::scene
