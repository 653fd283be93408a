// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The files are read back by hand: the container's header, the JSON, and the arrays behind the accessors.

#include "sweepkit/scene/gltf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>

#include "image_header.hpp"
#include "parsed_gltf.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/model.hpp"

namespace sweepkit::scene {
namespace {

TEST(Gltf, OneNodeOneMeshOnePrimitiveForEachObjectNamedForIt) {
  const Parsed parsed = glb(scene_text(R"("materials": {"m": {}})", kVase + ", " + kFloor));
  EXPECT_EQ(parsed.root["asset"], (json{{"version", "2.0"}, {"generator", "sweepkit 0.1.0"}}));
  ASSERT_EQ(parsed.root["meshes"].size(), 2u);
  ASSERT_EQ(parsed.root["nodes"].size(), 3u);
  for (std::size_t i = 0; i < 2; ++i) {
    const char* name = i == 0 ? "vase" : "floor";
    EXPECT_EQ(parsed.root["meshes"][i]["name"], name);
    EXPECT_EQ(parsed.root["meshes"][i]["primitives"].size(), 1u);
    EXPECT_EQ(parsed.root["nodes"][i]["name"], name);
    EXPECT_EQ(parsed.root["nodes"][i]["mesh"], i);
  }
  EXPECT_EQ(parsed.root["scenes"][0]["nodes"], (json{0, 1, 2}));
}

TEST(Gltf, HoldsTheMeshesOwnNumbers) {
  const std::string text = scene_text(R"("materials": {"m": {}})", kVase);
  const Document document = parse(text);
  const Model model = build(document, plan(document, {.product = Request::Product::kMeshFile}));
  const MeshView& mesh = model.scene.meshes[0];
  const Parsed parsed = glb(text);
  const json& attributes = parsed.primitive()["attributes"];
  const auto positions = parsed.accessor<float>(attributes["POSITION"]);
  const auto normals = parsed.accessor<float>(attributes["NORMAL"]);
  const auto texcoords = parsed.accessor<float>(attributes["TEXCOORD_0"]);
  const auto indices = parsed.accessor<std::uint16_t>(parsed.primitive()["indices"]);
  ASSERT_EQ(positions.size(), 3 * mesh.positions.size());
  EXPECT_EQ(std::memcmp(positions.data(), mesh.positions.data(), mesh.positions.size_bytes()), 0);
  EXPECT_EQ(std::memcmp(normals.data(), mesh.normals.data(), mesh.normals.size_bytes()), 0);
  for (std::size_t i = 0; i < mesh.texcoords.size(); ++i) {
    EXPECT_EQ(texcoords[2 * i], mesh.texcoords[i].x);
    EXPECT_EQ(texcoords[2 * i + 1], 1 - mesh.texcoords[i].y);
  }
  ASSERT_EQ(indices.size(), 3 * mesh.triangles.size());
  for (std::size_t i = 0; i < indices.size(); ++i) EXPECT_EQ(indices[i], mesh.triangles[i / 3][i % 3]);
}

TEST(Gltf, PositionsHaveTheirExactBounds) {
  const Parsed parsed = glb(scene_text(R"("materials": {"m": {}})", kVase));
  const std::size_t index = parsed.primitive()["attributes"]["POSITION"];
  const auto positions = parsed.accessor<float>(index);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float low = positions[axis];
    float high = low;
    for (std::size_t i = axis; i < positions.size(); i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    EXPECT_EQ(parsed.root["accessors"][index]["min"][axis].get<float>(), low);
    EXPECT_EQ(parsed.root["accessors"][index]["max"][axis].get<float>(), high);
  }
}

TEST(Gltf, ViewsAreAlignedAndInsideTheBuffer) {
  const Parsed parsed =
      glb(scene_text(R"("textures": {"t": {"procedural": "tiles"}}, "materials": {"m": {"texture": "t"}})",
                     kVase + ", " + kFloor));
  const std::size_t size = parsed.root["buffers"][0]["byteLength"];
  EXPECT_FALSE(parsed.root["buffers"][0].contains("uri"));
  for (const json& view : parsed.root["bufferViews"]) {
    const std::size_t offset = view.value("byteOffset", std::size_t{0});
    EXPECT_EQ(offset % 4, 0u);
    EXPECT_LE(offset + view["byteLength"].get<std::size_t>(), size);
  }
}

// 255 x 255 cells make 256 x 256 = 65536 vertices, one too many for 16 bits; 254 x 256 cells make 65535.
TEST(Gltf, IndicesAre16BitsWhereTheyReach) {
  const auto component = [](const std::string& cells) {
    const Parsed parsed =
        glb(scene_text("", R"({"name": "a", "plane": {"size": [1, 1]}, "tessellation": {)" + cells + "}}"));
    const std::size_t vertices =
        parsed.root["accessors"][parsed.primitive()["attributes"]["POSITION"].get<std::size_t>()]["count"];
    return std::pair(
        vertices, parsed.root["accessors"][parsed.primitive()["indices"].get<std::size_t>()]["componentType"]
                      .get<int>());
  };
  EXPECT_EQ(component(R"("contour": 254, "trajectory": 256)"), std::pair(std::size_t{65535}, 5123));
  EXPECT_EQ(component(R"("contour": 255, "trajectory": 255)"), std::pair(std::size_t{65536}, 5125));
}

TEST(Gltf, NodesArePlacedAndCarryTheMeshesOrigin) {
  const std::string text = scene_text(
      "", R"({"name": "far", "translate": [1000000, 0, 0], "rotate_deg": [0, 0, 90], "scale": [2, 3, 4],
      "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[5000000, 7, 0], [5000000, 8, 0]]}}})");
  const Document document = parse(text);
  const Model model = build(document, plan(document, {.product = Request::Product::kMeshFile}));
  const json node = glb(text).root["nodes"][0];
  const glm::dvec3 at(model.scene.objects[0].world_from_object * glm::dvec4(model.scene.meshes[0].origin, 1));
  EXPECT_EQ(node["scale"], (json{2.0, 3.0, 4.0}));
  // The origin alone, when it is not zero: the product of doubles is exact here.
  if (at != glm::dvec3(0.0)) {
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(node["translation"][static_cast<std::size_t>(i)].get<double>(), at[i]);
  }
  EXPECT_NEAR(node["rotation"][2].get<double>(), std::numbers::sqrt2 / 2, 1e-15);
  EXPECT_NEAR(node["rotation"][3].get<double>(), std::numbers::sqrt2 / 2, 1e-15);
}

TEST(Gltf, InstancesAreNodesUnderTheObjectsAndShareItsMesh) {
  const std::string plane = R"("plane": {"size": [1, 1]}, "translate": [1, 0, 0], "scale": [2, 2, 2])";
  const Parsed parsed = glb(
      scene_text("", R"({"name": "one", "instances": [{"translate": [0, 5, 0]}], )" + plane +
                         R"(}, {"name": "two", "instances": [{}, {"translate": [0, 0, 7], "scale": 3}], )" +
                         plane + "}"));
  const json& nodes = parsed.root["nodes"];
  EXPECT_EQ(parsed.root["meshes"].size(), 2u);
  EXPECT_EQ(parsed.root["scenes"][0]["nodes"], (json{0, 1, 4}));
  EXPECT_EQ(
      nodes[0],
      (json{{"name", "one"}, {"mesh", 0}, {"translation", {1.0, 5.0, 0.0}}, {"scale", {2.0, 2.0, 2.0}}}));
  EXPECT_EQ(nodes[1], (json{{"name", "two"}, {"children", {2, 3}}}));
  EXPECT_EQ(nodes[2], (json{{"mesh", 1}, {"translation", {1.0, 0.0, 0.0}}, {"scale", {2.0, 2.0, 2.0}}}));
  EXPECT_EQ(nodes[3], (json{{"mesh", 1}, {"translation", {3.0, 0.0, 7.0}}, {"scale", {6.0, 6.0, 6.0}}}));
}

TEST(Gltf, AnInstanceThatShearsItsObjectIsRefused) {
  const std::string text =
      scene_text("", R"({"name": "a", "plane": {"size": [1, 1]}, "rotate_deg": [0, 30, 0],
      "instances": [{}, {"scale": [1, 1, 2]}]})");
  try {
    glb(text);
    FAIL() << "a sheared node was written";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(),
              "the object \"a\" is sheared by an instance, which glTF cannot place; give that instance one "
              "scale for "
              "all directions");
  }
}

TEST(Gltf, TheCameraIsTheScenes) {
  const Parsed parsed = glb(scene_text(
      R"("camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "fov_deg": 90, "width": 200, "height": 100})"));
  const json& perspective = parsed.root["cameras"][0]["perspective"];
  EXPECT_EQ(perspective["yfov"].get<double>(), std::numbers::pi / 2);
  EXPECT_EQ(perspective["aspectRatio"].get<double>(), 2);
  EXPECT_LT(perspective["znear"].get<double>(), 5);
  EXPECT_GT(perspective["zfar"].get<double>(), 5);
  const json& node = parsed.root["nodes"].back();
  EXPECT_EQ(node["translation"], (json{0.0, 0.0, 5.0}));
  EXPECT_FALSE(node.contains("rotation"));
}

TEST(Gltf, NothingUnusedIsWritten) {
  const json root =
      glb(scene_text(
              R"("textures": {"t": {"image": "not there.png"}}, "materials": {"m": {}, "other": {"texture": "t"}})",
              kVase))
          .root;
  EXPECT_EQ(root["materials"].size(), 1u);
  for (const char* key :
       {"textures", "images", "samplers", "extensionsUsed", "extensionsRequired", "animations", "skins"}) {
    EXPECT_FALSE(root.contains(key)) << key;
  }
  EXPECT_TRUE(root["meshes"][0]["primitives"][0]["attributes"].contains("TEXCOORD_0"))
      << "people texture elsewhere";
}

TEST(Gltf, ObjectsThatShareAMaterialShareIt) {
  const std::string two =
      R"({"name": "a", "plane": {"size": [1, 1]}, "material": "m"}, {"name": "b", "plane": {"size": [1, 1]}, "material": "m"},
                             {"name": "c", "plane": {"size": [1, 1]}}, {"name": "d", "plane": {"size": [1, 1]}})";
  const Parsed parsed = glb(scene_text(
      R"("textures": {"t": {"image": "../textures/vase_bands.png", "wrap": "clamp"}}, "materials": {"m": {"texture": "t"}})",
      two));
  EXPECT_EQ(parsed.root["materials"].size(), 2u);
  EXPECT_EQ(parsed.root["materials"][0]["name"], "m");
  EXPECT_EQ(parsed.root["materials"][1]["name"], "default");
  EXPECT_EQ(parsed.root["images"].size(), 1u);
  EXPECT_EQ(parsed.primitive(0)["material"], parsed.primitive(1)["material"]);
  EXPECT_EQ(parsed.primitive(2)["material"], parsed.primitive(3)["material"]);
  EXPECT_EQ(parsed.root["samplers"][0]["wrapS"], 33071);
}

TEST(Gltf, ImagesStandInsideAGlbAndBesideAGltf) {
  const std::string text = scene_text(
      R"("textures": {"t": {"image": "../textures/vase_bands.png"}}, "materials": {"m": {"texture": "t"}})",
      kVase);
  const Parsed inside = glb(text);
  const json& image = inside.root["images"][0];
  EXPECT_EQ(image["mimeType"], "image/png");
  EXPECT_FALSE(image.contains("uri"));
  EXPECT_EQ(std::memcmp(inside.view(image["bufferView"]), "\x89PNG", 4), 0);

  const GltfFile beside = make(text, "some folder/my vase #1.gltf");
  ASSERT_EQ(beside.files.size(), 3u);
  EXPECT_EQ(beside.files[0].name, "my vase #1_0.png");
  EXPECT_EQ(beside.files[1].name, "my vase #1.bin");
  EXPECT_EQ(beside.files[2].name, "my vase #1.gltf") << "last, since it names the others";
  const auto* first = reinterpret_cast<const char*>(beside.files[2].bytes.data());
  const json root = json::parse(first, first + beside.files[2].bytes.size());
  EXPECT_EQ(root["images"][0]["uri"], "my%20vase%20%231_0.png");
  EXPECT_EQ(root["buffers"],
            (json::array({{{"uri", "my%20vase%20%231.bin"}, {"byteLength", beside.files[1].bytes.size()}}})));
  EXPECT_EQ(std::memcmp(beside.files[0].bytes.data(), "\x89PNG", 4), 0);
  EXPECT_EQ(root["accessors"], inside.root["accessors"].is_array() ? root["accessors"] : json());
}

TEST(Gltf, ProceduralTexturesAreBakedOnceForEachSurface) {
  const std::string text =
      scene_text(R"("textures": {"t": {"procedural": "marble"}}, "materials": {"m": {"texture": "t"}})",
                 kVase + R"(, {"name": "b", "plane": {"size": [1, 1]}, "material": "m"})");
  const Parsed parsed = glb(text);
  EXPECT_EQ(parsed.root["images"].size(), 2u);
  EXPECT_EQ(parsed.root["materials"].size(), 2u);
  EXPECT_EQ(parsed.file.ledger[Part::kBakes].calls, 2u);
  std::uint64_t texels = 0;
  for (const json& image : parsed.root["images"]) {
    const json& view = parsed.root["bufferViews"][image["bufferView"].get<std::size_t>()];
    const auto header =
        image_header({parsed.view(image["bufferView"]), view["byteLength"].get<std::size_t>()});
    ASSERT_TRUE(header);
    EXPECT_EQ(std::max(header->width, header->height), 32);
    texels += static_cast<std::uint64_t>(header->width) * static_cast<std::uint64_t>(header->height);
  }
  EXPECT_EQ(parsed.file.ledger[Part::kBakes].bytes, texels * 3 * 2) << "16-bit RGB";
  for (std::size_t i = 0; i < 2; ++i) {
    for (const float coordinate : parsed.accessor<float>(parsed.primitive(i)["attributes"]["TEXCOORD_0"])) {
      EXPECT_GE(coordinate, 0);
      EXPECT_LE(coordinate, 1);
    }
  }
}

TEST(Gltf, AnImageCostsNoBake) {
  const Parsed parsed = glb(scene_text(
      R"("textures": {"t": {"image": "../textures/vase_bands.png"}}, "materials": {"m": {"texture": "t"}})",
      kVase));
  EXPECT_EQ(parsed.file.ledger[Part::kBakes].calls, 0u);
  EXPECT_EQ(parsed.file.ledger[Part::kBakes].bytes, 0u);
}

TEST(Gltf, ExtensionsAreUsedOnlyByWhatReflectsAndNeverRequired) {
  const json root = glb(scene_text(R"("materials": {"m": {"reflect": 0.3}})", kVase)).root;
  EXPECT_EQ(root["extensionsUsed"], json{"KHR_materials_specular"});
  EXPECT_FALSE(root.contains("extensionsRequired"));
  const json& factor = root["materials"][0]["extensions"]["KHR_materials_specular"]["specularColorFactor"];
  EXPECT_NEAR(factor[0].get<double>(), 7.5, 1e-6);
}

// Two glass balls of one material and unlike sizes, and a sheet of it.
std::string glass_scene() {
  const auto ball = [](const char* name, const char* radius) {
    return R"({"name": ")" + std::string(name) +
           R"(", "material": "glass", "revolve": {"contour": {"arc": {"from_deg": -90, "to_deg": 90, "radius": )" +
           radius + "}}}}";
  };
  return scene_text(
      R"("materials": {"glass": {"diffuse": [0, 0, 0], "transmit": 1, "reflect": 1, "ior": 1.6, "fresnel": "exact",
                                 "absorption": [1, 2, 4]}})",
      ball("small", "0.1") + ", " + ball("large", "0.2") +
          R"(, {"name": "sheet", "material": "glass", "plane": {"size": [1, 1]}})");
}

TEST(Gltf, GlassTellsHowThickEachBodyIs) {
  const Parsed parsed = glb(glass_scene());
  const json& materials = parsed.root["materials"];
  ASSERT_EQ(materials.size(), 3u);
  for (std::size_t i = 0; i < 2; ++i) {
    const json& volume = materials[i]["extensions"]["KHR_materials_volume"];
    // 4 r / 3; 64 x 64 cells of a ball lack less than a hundredth of its radius.
    const double radius = i == 0 ? 0.1 : 0.2;
    EXPECT_NEAR(volume["thicknessFactor"].get<double>(), 4 * radius / 3, 0.01 * radius);
    EXPECT_EQ(volume["attenuationDistance"].get<double>(), 0.25);
    EXPECT_FALSE(materials[i].contains("doubleSided"));
    EXPECT_FALSE(materials[i].contains("alphaMode")) << "OPAQUE";
  }
  EXPECT_FALSE(materials[2]["extensions"].contains("KHR_materials_volume"));
  EXPECT_EQ(materials[2]["doubleSided"], true);
  EXPECT_EQ(parsed.root["extensionsUsed"],
            (json{"KHR_materials_ior", "KHR_materials_transmission", "KHR_materials_volume"}));
  EXPECT_FALSE(parsed.root.contains("extensionsRequired"));
  EXPECT_EQ(parsed.file.ledger[Part::kThicknesses].calls, 3u);
  EXPECT_GT(parsed.file.ledger[Part::kThicknesses].bytes, 0u);
}

TEST(Gltf, CompatibleGlassIsBlendedAndUsesNoExtension) {
  const json root = glb(glass_scene(), {.look = GltfLook::kCompatible}).root;
  EXPECT_FALSE(root.contains("extensionsUsed"));
  for (const json& material : root["materials"]) {
    EXPECT_EQ(material["alphaMode"], "BLEND");
    EXPECT_FALSE(material.contains("extensions"));
  }
}

TEST(Gltf, UnlitUsesThatExtensionAlone) {
  const json root =
      glb(scene_text(R"("materials": {"m": {"reflect": 0.3}})", kVase), {.look = GltfLook::kUnlit}).root;
  EXPECT_EQ(root["extensionsUsed"], json{"KHR_materials_unlit"});
  EXPECT_EQ(root["materials"][0]["extensions"], (json{{"KHR_materials_unlit", json::object()}}));
}

TEST(Gltf, WhatIsNotGlassIsNotMeasured) {
  const Parsed parsed = glb(scene_text(R"("materials": {"m": {"reflect": 0.3}})", kVase));
  EXPECT_EQ(parsed.file.ledger[Part::kThicknesses].calls, 0u);
  EXPECT_EQ(parsed.file.ledger[Part::kThicknesses].bytes, 0u);
}

TEST(Gltf, MaterialsWithEqualTermsAreOne) {
  const json root =
      glb(scene_text(
              R"("materials": {"m": {"reflect": 0.3}, "same": {"reflect": 0.3}, "other": {"reflect": 0.2}})",
              kVase + R"(, {"name": "b", "material": "same", "plane": {"size": [1, 1]}},
                                  {"name": "c", "material": "other", "plane": {"size": [1, 1]}})"))
          .root;
  ASSERT_EQ(root["materials"].size(), 2u);
  EXPECT_EQ(root["meshes"][0]["primitives"][0]["material"], root["meshes"][1]["primitives"][0]["material"]);
}

TEST(Gltf, ObjectsOfOneShapeShareItsArraysAndKeepTheirNames) {
  const auto rod = [](const std::string& name, const std::string& more) {
    return R"({"name": ")" + name + R"(", "sweep": {"contour": {"circle": {"radius": 0.1}},
        "trajectory": {"line": [[0, 0, 0], [0, 1, 0]]}})" +
           more + "}";
  };
  const Parsed parsed =
      glb(scene_text(R"("materials": {"m": {"diffuse": [1, 0, 0]}})",
                     rod("a", "") + ", " + rod("b", R"(, "translate": [1, 2, 3], "material": "m")")));
  EXPECT_EQ(parsed.root["meshes"][1]["name"], "b");
  EXPECT_EQ(parsed.primitive(0)["attributes"], parsed.primitive(1)["attributes"]);
  EXPECT_EQ(parsed.primitive(0)["indices"], parsed.primitive(1)["indices"]);
  EXPECT_NE(parsed.primitive(0)["material"], parsed.primitive(1)["material"]);
  EXPECT_EQ(parsed.root["accessors"].size(), 4u);
  EXPECT_EQ(parsed.root["bufferViews"].size(), 4u);
  const json& positions =
      parsed.root["accessors"][parsed.primitive(0)["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(positions["min"].size(), 3u) << "whoever asks for it again";
  EXPECT_EQ(positions["max"].size(), 3u);
}

TEST(Gltf, APositionArrayThatEqualsTheNormalsHasBoundsAllTheSame) {
  const std::vector<glm::vec3> units = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<glm::vec2> texcoords(3);
  const std::vector<sweep::Triangle> triangles = {{0, 1, 2}};
  Scene scene;
  scene.meshes.push_back({units, units, texcoords, triangles, {}, {}, {}});
  scene.objects.push_back({"a", 0, {}, glm::dmat4(1.0)});
  const GltfFile file = make_gltf(scene, {}, "a.gltf", {});
  const auto* first = reinterpret_cast<const char*>(file.files.back().bytes.data());
  const json root = json::parse(first, first + file.files.back().bytes.size());
  const json& position = root["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
  EXPECT_EQ(root["accessors"][position.get<std::size_t>()]["max"], (json{1.0, 1.0, 1.0}));
}

// Ten million metres away float32 counts in whole metres; about the object's own origin in nanometres.
TEST(Gltf, FarFromTheOriginNothingIsLost) {
  const auto rod = [](const std::string& at, const std::string& translate) {
    return glb(scene_text("", R"({"name": "a", "translate": [)" + translate + R"(, 0, 0], "sweep": {
        "contour": {"circle": {"radius": 0.01}}, "trajectory": {"line": [[)" +
                                  at + ", 5, 7], [" + at + R"(, 6, 7]]}}})"));
  };
  const auto positions = [](const Parsed& parsed) {
    return parsed.accessor<float>(parsed.primitive()["attributes"]["POSITION"]);
  };
  const Parsed near = rod("0", "0");
  const auto wanted = positions(near);
  for (const auto& [at, translate] :
       {std::pair("10000000", "0"), std::pair("0", "10000000"), std::pair("10000000", "-10000000")}) {
    const Parsed far = rod(at, translate);
    const auto got = positions(far);
    ASSERT_EQ(got.size(), wanted.size());
    // Where they are in the world less where they would be near: double in the node, 2^-24 of 1 m in float32,
    // and what 1e7 plus a hundredth loses in double, 2^-30.
    const json zero = {0.0, 0.0, 0.0};
    const json there = far.root["nodes"][0].value("translation", zero);
    const json here = near.root["nodes"][0].value("translation", zero);
    const double shift = std::stod(at) + std::stod(translate);
    for (std::size_t i = 0; i < got.size(); ++i) {
      const double moved = there[i % 3].get<double>() - here[i % 3].get<double>() - (i % 3 == 0 ? shift : 0);
      EXPECT_NEAR(got[i] + moved, wanted[i], 1.3e-7) << i;
    }
    // And no position is far from the mesh's own origin.
    EXPECT_LT(std::abs(got[0]), 2);
  }
}

TEST(Gltf, KeepsTheCopyright) {
  EXPECT_EQ(glb(scene_text(""), {.copyright = "© 2026 \"A\""}).root["asset"]["copyright"], "© 2026 \"A\"");
  try {
    glb(scene_text(""), {.copyright = "\xff"});
    FAIL() << "no UTF-8 was written";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "the copyright is no UTF-8 text");
  }
}

TEST(Gltf, OneObjectAlone) {
  const std::string text = scene_text(R"("materials": {"m": {}})", kVase + ", " + kFloor);
  const json root = glb(text, {.object = "floor"}).root;
  ASSERT_EQ(root["meshes"].size(), 1u);
  EXPECT_EQ(root["meshes"][0]["name"], "floor");
  try {
    glb(text, {.object = "flor"});
    FAIL() << "there is no such object";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "there is no object \"flor\"; there is \"vase\", \"floor\"");
  }
}

TEST(Gltf, TheSameSceneGivesTheSameBytes) {
  const std::string text = scene_text(
      R"("textures": {"t": {"procedural": "marble"}}, "materials": {"m": {"texture": "t"}})", kVase);
  for (const char* name : {"a.glb", "a.gltf"}) {
    const GltfFile one = make(text, name);
    const GltfFile two = make(text, name);
    ASSERT_EQ(one.files.size(), two.files.size());
    for (std::size_t i = 0; i < one.files.size(); ++i)
      EXPECT_EQ(one.files[i].bytes, two.files[i].bytes) << one.files[i].name;
  }
}

TEST(Gltf, NamesKeepTheirLetters) {
  const json root =
      glb(scene_text("", R"({"name": "Krügerl \"buffers\" \u4e2d", "plane": {"size": [1, 1]}})")).root;
  EXPECT_EQ(root["nodes"][0]["name"], "Krügerl \"buffers\" 中");
}

TEST(Gltf, StandardOutputIsAGlb) {
  const GltfFile file = make(scene_text(""), "-");
  ASSERT_EQ(file.files.size(), 1u);
  EXPECT_EQ(std::memcmp(file.files[0].bytes.data(), "glTF", 4), 0);
}

// A hand-made scene, since a document of this size would be slow: one image's worth of bytes too many.
TEST(Gltf, WhatCannotBeWrittenIsRefused) {
  const std::vector<glm::vec3> positions(3);
  const std::vector<glm::vec2> texcoords(3);
  const std::vector<sweep::Triangle> triangles = {{0, 1, 2}};
  Scene scene;
  scene.meshes.push_back({positions, positions, texcoords, triangles, {}, {}, {}});
  scene.objects.push_back({"a", 0, {}, glm::dmat4(1.0)});
  const GltfOptions options;
  EXPECT_NO_THROW(make_gltf(scene, {}, "a.glb", options));
  scene.objects[0].world_from_object[1][0] = 0.5;
  EXPECT_THROW(make_gltf(scene, {}, "a.glb", options), InputError) << "sheared";
  scene.objects[0].world_from_object = glm::dmat4(1.0);
  scene.meshes[0].triangles = {};
  EXPECT_THROW(make_gltf(scene, {}, "a.glb", options), InputError) << "no triangles";
  scene.objects.clear();
  EXPECT_THROW(make_gltf(scene, {}, "a.glb", options), InputError) << "no objects";
}

// The bytes are never touched: the size alone is refused. 2^28 vertices would take 3 GiB of positions.
TEST(Gltf, OverTwoGibibytesIsRefused) {
  const std::size_t vertices = std::size_t{1} << 28;
  const std::vector<sweep::Triangle> triangles = {{0, 1, 2}};
  const glm::vec3 nothing(0.0f);
  Scene scene;
  scene.meshes.push_back({{&nothing, 1}, {&nothing, vertices}, {}, triangles, {}, {}, {}});
  scene.objects.push_back({"a", 0, {}, glm::dmat4(1.0)});
  try {
    make_gltf(scene, {}, "a.glb", {});
    FAIL() << "3 GiB were written";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(),
              "the file would be over 2 GiB; ask for fewer cells, smaller images or one object at a time");
  }
}

}  // namespace
}  // namespace sweepkit::scene
