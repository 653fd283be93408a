// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Normal maps in glTF and .mtl files.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <glm/gtc/quaternion.hpp>
#include <tuple>

#include "parsed_gltf.hpp"
#include "sweepkit/scene/mesh_output.hpp"
#include "sweepkit/sweep/tangents.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::scene {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

const std::string kPlane = R"({"name": "o", "material": "m", "plane": {"size": [1, 1]}})";

class GltfNormalMapTest : public testing::Test {
 protected:
  GltfNormalMapTest() : folder(fs::path(testing::TempDir()) / ("normals_" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
    // Slopes of any size both ways, so that no coding of colours keeps them.
    map = {16, 8, 3, std::vector<std::uint16_t>()};
    auto& texels = std::get<std::vector<std::uint16_t>>(map.texels);
    for (int i = 0; i < 16 * 8; ++i) {
      const glm::dvec3 n = glm::normalize(glm::dvec3(std::sin(i), std::cos(2 * i), 1));
      for (glm::length_t k = 0; k < 3; ++k)
        texels.push_back(static_cast<std::uint16_t>(257 * std::lround(255 * 0.5 * (n[k] + 1))));
    }
    write("map.png", texmap::ImageFormat::kPng);
  }
  ~GltfNormalMapTest() override { fs::remove_all(folder); }

  void write(const std::string& name, texmap::ImageFormat format) const {
    const Bytes bytes = texmap::encode_image(map, format, texmap::ColorSpace::kLinear);
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  static std::string scene_of(const std::string& material, const std::string& object = kPlane,
                              const std::string& map = R"({"image": "map.png"})") {
    return scene_text(
        R"("textures": {"map": )" + map +
            R"(, "checks": {"procedural": "checker", "scale": 2}, "marble": {"procedural": "marble"}}, "materials": {"m": {"normal_map": "map")" +
            material + "}}",
        object);
  }

  // The JSON, what stands beside, the model.
  struct Written {
    json root;
    std::vector<NamedBytes> files;
    Ledger ledger;
  };
  Written written(const std::string& text, const GltfOptions& options = {.bake_size = 32},
                  const Request& request = {.product = Request::Product::kMeshFile}) const {
    const Document document = parse_document(text, folder / "s.json");
    const Plan needs = plan(document, request);
    const Model model = build(document, needs);
    GltfFile file = make_gltf(model.scene, needs, "s.gltf", options);
    const auto* begin = reinterpret_cast<const char*>(file.files.back().bytes.data());
    file.ledger.add(model.ledger);
    return {json::parse(begin, begin + file.files.back().bytes.size()), std::move(file.files), file.ledger};
  }

  Bytes read(const std::string& name) const {
    std::ifstream stream(folder / name, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
  }
  // The image's numbers, as an image reader sees them.
  texmap::Image decoded(const Bytes& png) const {
    std::ofstream(folder / "again.png", std::ios::binary)
        .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    return texmap::read_image(folder / "again.png", texmap::ColorSpace::kLinear);
  }

  const fs::path folder;
  texmap::Image map;
};

TEST_F(GltfNormalMapTest, IsANormalTextureWithScaleAndTangentsAndTheFileIsCopied) {
  const Written file = written(scene_of(R"(, "normal_strength": 0.5)"));
  const json& normal = file.root["materials"][0]["normalTexture"];
  EXPECT_EQ(normal, json::parse(R"({"index": 0, "scale": 0.5})"));
  EXPECT_EQ(file.root["materials"][0]["pbrMetallicRoughness"].count("baseColorTexture"), 0u);
  EXPECT_EQ(file.root["meshes"][0]["primitives"][0]["attributes"].count("TANGENT"), 1u);
  EXPECT_EQ(file.files[0].bytes, read("map.png"));
  EXPECT_EQ(file.ledger[Part::kNormalMaps].calls, 1u);
}

TEST_F(GltfNormalMapTest, WithoutOneThereAreNoTangents) {
  const Written file = written(scene_text(R"("materials": {"m": {}})", kPlane));
  EXPECT_EQ(file.root["meshes"][0]["primitives"][0]["attributes"].count("TANGENT"), 0u);
  EXPECT_EQ(file.ledger[Part::kNormalMaps].bytes, 0u);
  EXPECT_EQ(file.ledger[Part::kNormalMaps].calls, 0u);
}

TEST_F(GltfNormalMapTest, OneThatNeedsAChangeKeepsItsNumbers) {
  write("map.tif", texmap::ImageFormat::kTiff);
  const Written file = written(scene_of("", kPlane, R"({"image": "map.tif"})"));
  EXPECT_EQ(decoded(file.files[0].bytes).texels, map.texels);
}

TEST_F(GltfNormalMapTest, IsReadAsLinearWhateverItsColorSpaceSays) {
  const Document document = parse_document(
      scene_of("", kPlane, R"({"image": "map.png", "color_space": "srgb"})"), folder / "s.json");
  EXPECT_EQ(std::get<ImageEntry>(document.textures[0].source).color_space, texmap::ColorSpace::kLinear);
}

// 8-bit steps of 2/255 in each of the numbers that the mean is taken of, and in what is written.
TEST_F(GltfNormalMapTest, MaxTextureShrinksItAsVectors) {
  const Written file = written(scene_of(""), {.max_texture = 8});
  const texmap::Image small = decoded(file.files[0].bytes);
  ASSERT_EQ(small.width, 8);
  ASSERT_EQ(small.height, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) {
      glm::dvec3 sum(0.0);
      for (int k = 0; k < 4; ++k) sum += 2.0 * glm::dvec3(map.color(2 * x + k % 2, 2 * y + k / 2)) - 1.0;
      const glm::dvec3 n = 2.0 * glm::dvec3(small.color(x, y)) - 1.0;
      EXPECT_LT(glm::distance(n, glm::normalize(sum)), std::sqrt(3.0) / 255 + 1e-4);
    }
  }
}

TEST_F(GltfNormalMapTest, ColoursThatAreBakedOverTheMeshLeaveItTheMeshsOwnTexcoords) {
  const Written file = written(scene_of(R"(, "texture": "marble")"));
  const json& primitive = file.root["meshes"][0]["primitives"][0];
  EXPECT_EQ(file.root["materials"][0]["normalTexture"]["texCoord"], 1);
  EXPECT_EQ(primitive["attributes"].count("TEXCOORD_1"), 1u);
  const Written plain = written(scene_of(R"(, "texture": "checks")"));
  EXPECT_EQ(plain.root["materials"][0]["normalTexture"].count("texCoord"), 0u);
  EXPECT_EQ(plain.root["meshes"][0]["primitives"][0]["attributes"].count("TEXCOORD_1"), 0u);
}

// A corner's place, normal, and frame in the world, by the node's matrix and glTF's rules.
TEST_F(GltfNormalMapTest, WhatIsMirroredEverywhereIsTurnedRoundItselfUnderNodesThatAreNot) {
  const auto placed = [&](const std::string& placement) {
    const Document document = parse_document(
        scene_of("", R"({"name": "o", "material": "m", "tessellation": {"contour": 6, "trajectory": 4},
            "sweep": {"contour": {"circle": {"radius": 0.2}}, "trajectory": {"line": [[1, 0, 0], [1, 2, 0.5]]}})" +
                         placement + "}"),
        folder / "s.json");
    const Plan needs = plan(document, {.product = Request::Product::kMeshFile});
    const Model model = build(document, needs);
    const GltfFile file = make_gltf(model.scene, needs, "s.gltf", {});
    const auto* begin = reinterpret_cast<const char*>(file.files.back().bytes.data());
    return std::tuple(
        json::parse(begin, begin + file.files.back().bytes.size()), file.files[1].bytes,
        model.scene.meshes[0].origin,
        std::vector(model.scene.meshes[0].positions.begin(), model.scene.meshes[0].positions.end()),
        model.scene.objects[0].world_from_object);
  };
  const auto floats = [](const json& root, const std::vector<std::byte>& buffer, const std::string& attribute,
                         std::size_t per) {
    const json& accessor =
        root["accessors"][root["meshes"][0]["primitives"][0]["attributes"][attribute].get<std::size_t>()];
    const json& view = root["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::vector<float> values(per * accessor["count"].get<std::size_t>());
    std::memcpy(values.data(), buffer.data() + view.value("byteOffset", std::size_t{0}), 4 * values.size());
    return values;
  };
  const auto scale_of = [](const json& node) {
    const std::vector<double> scale = node.value("scale", std::vector<double>{1, 1, 1});
    return scale[0] * scale[1] * scale[2];
  };
  const auto [plain, plain_buffer, origin, positions, unmoved] = placed("");
  const auto [root, buffer, same_origin, same_positions, world] =
      placed(R"(, "scale": [1, -2, 1], "translate": [3, 0, 1])");
  EXPECT_LT(glm::determinant(glm::dmat3(world)), 0);
  const json& node = root["nodes"][0];
  EXPECT_GT(scale_of(node), 0);
  const std::vector<double> r = node.value("rotation", std::vector<double>{0, 0, 0, 1});
  const std::vector<double> s = node.value("scale", std::vector<double>{1, 1, 1});
  const std::vector<double> t = node.value("translation", std::vector<double>{0, 0, 0});
  const glm::dmat3 turn(glm::dquat(r[3], r[0], r[1], r[2]));
  const std::vector<float> written = floats(root, buffer, "POSITION", 3);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3 local(written[3 * i], written[3 * i + 1], written[3 * i + 2]);
    const glm::dvec3 there = turn * (glm::dvec3(s[0], s[1], s[2]) * local) + glm::dvec3(t[0], t[1], t[2]);
    const glm::dvec3 expected(world * glm::dvec4(glm::dvec3(positions[i]) + origin, 1));
    EXPECT_LT(glm::distance(there, expected), 1e-6) << i;
  }
  const std::vector<float> tangents = floats(root, buffer, "TANGENT", 4);
  const std::vector<float> before = floats(plain, plain_buffer, "TANGENT", 4);
  for (std::size_t i = 0; i < positions.size(); ++i) EXPECT_EQ(tangents[4 * i + 3], -before[4 * i + 3]);

  // Mixed instances stay as they are.
  const auto [mixed, mixed_buffer, a, b, c] = placed(R"(, "instances": [{}, {"scale": [-1, 1, 1]}])");
  EXPECT_EQ(floats(mixed, mixed_buffer, "TANGENT", 4), before);
}

TEST_F(GltfNormalMapTest, UnlitNeedsNone) {
  const Request unlit{.product = Request::Product::kMeshFile, .has_normal_maps = false};
  const Written file = written(scene_of(""), {.look = GltfLook::kUnlit}, unlit);
  EXPECT_EQ(file.root["materials"][0].count("normalTexture"), 0u);
  EXPECT_EQ(file.root.count("images"), 0u);
  EXPECT_EQ(file.root["meshes"][0]["primitives"][0]["attributes"].count("TANGENT"), 0u);
}

TEST_F(GltfNormalMapTest, MtlNamesItAndItsNumbersStay) {
  const auto obj = [&](const std::string& text) {
    const Document document = parse_document(text, folder / "s.json");
    const Plan needs = plan(document, {.product = Request::Product::kMeshFile, .has_tangents = false});
    return make_mesh_output(build(document, needs).scene, needs, "s.obj", {.bake_size = 32}).files;
  };
  const auto files = obj(scene_of(""));
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(decoded(files[0].bytes).texels, map.texels);
  const std::string library(reinterpret_cast<const char*>(files[1].bytes.data()), files[1].bytes.size());
  EXPECT_NE(library.find("\nnorm s_0.png\n"), std::string::npos) << library;
  const auto clamped =
      obj(scene_of(R"(, "texture": "checks")", kPlane, R"({"image": "map.png", "wrap": "clamp"})"));
  const std::string both(reinterpret_cast<const char*>(clamped[2].bytes.data()), clamped[2].bytes.size());
  EXPECT_NE(both.find("\nmap_Kd s_0.png\nnorm -clamp on s_1.png\n"), std::string::npos) << both;
  const auto fault_of = [&](const std::string& text) -> std::string {
    try {
      obj(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(
      fault_of(scene_of(R"(, "texture": "marble")")),
      "the material \"m\" has a normal map, and colours that are baked with (u,v) of their own, and .obj has "
      "one (u,v) for both; write a .glb, or leave the normal map out");
  EXPECT_EQ(
      fault_of(scene_of(R"(, "texture": "checks")", kPlane, R"({"image": "map.png", "wrap": "mirror"})")),
      "the material \"m\" has a texture and a normal map of which one alone is mirrored, and .obj has one "
      "(u,v) for both; write a .glb, or leave the normal map out");
}

}  // namespace
}  // namespace sweepkit::scene
