// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "sweepkit/scene/gltf_source.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "json_text.hpp"
#include "parsed_gltf.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

namespace fs = std::filesystem;

class GltfSourceTest : public testing::Test {
 protected:
  GltfSourceTest() : folder(fs::path(testing::TempDir()) / ("source_" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
  }
  ~GltfSourceTest() override { fs::remove_all(folder); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }
  fs::path write(const GltfFile& file) const {
    const NamedBytes& last = file.files.back();
    return write(last.name, {reinterpret_cast<const char*>(last.bytes.data()), last.bytes.size()});
  }
  std::string fault_of(const fs::path& file) const {
    try {
      read_gltf_source(file);
    } catch (const InputError& error) {
      return error.problem();
    }
    return "";
  }

  const fs::path folder;
};

const std::string kScene = scene_text(R"("materials": {"m": {}, "empty": {}})", kVase);

TEST_F(GltfSourceTest, ReturnsTheSceneAndEveryOption) {
  const SceneFile scene(kScene, "s.json");
  GltfOptions options{.object = "vase",
                      .bake_size = 77,
                      .texel_density = 12.5,
                      .has_tangents = true,
                      .look = GltfLook::kUnlit,
                      .images_in = GltfImages::kSeparate,
                      .image_format = texmap::ImageFormat::kJpeg,
                      .max_texture = 99,
                      .turntable_seconds = 2.5,
                      .copyright = "© \"me\"",
                      .is_quantized = true,
                      .position_bits = 12,
                      .is_packed = true,
                      .scene = scene.text()};
  for (const char* name : {"a.glb", "a.gltf"}) {
    const GltfSource source = read_gltf_source(write(make(kScene, name, options)));
    EXPECT_EQ(source.scene, options.scene);
    EXPECT_EQ(source.options.object, options.object);
    EXPECT_EQ(source.options.bake_size, options.bake_size);
    EXPECT_EQ(source.options.texel_density, options.texel_density);
    EXPECT_EQ(source.options.has_tangents, options.has_tangents);
    EXPECT_EQ(source.options.look, options.look);
    EXPECT_EQ(source.options.images_in, options.images_in);
    EXPECT_EQ(source.options.image_format, options.image_format);
    EXPECT_EQ(source.options.max_texture, options.max_texture);
    EXPECT_EQ(source.options.turntable_seconds, options.turntable_seconds);
    EXPECT_EQ(source.options.copyright, options.copyright);
    EXPECT_EQ(source.options.is_quantized, options.is_quantized);
    EXPECT_EQ(source.options.position_bits, options.position_bits);
    EXPECT_EQ(source.options.is_packed, options.is_packed);
  }
  options.image_format = texmap::ImageFormat::kPng;
  options.images_in = GltfImages::kEmbedded;
  options.look = GltfLook::kCompatible;
  options.is_quantized = options.is_packed = false;  // what grows is neither
  options.grow_seconds = 7;
  const GltfSource source = read_gltf_source(write(make(kScene, "a.glb", options)));
  EXPECT_EQ(source.options.image_format, options.image_format);
  EXPECT_EQ(source.options.images_in, options.images_in);
  EXPECT_EQ(source.options.look, options.look);
  EXPECT_EQ(source.options.grow_seconds, options.grow_seconds);
}

TEST_F(GltfSourceTest, UsualOptionsTakeNoPlaceAndWithoutASceneThereAreNoExtras) {
  EXPECT_FALSE(glb(kScene).root.contains("extras"));
  const json extras = glb(kScene, {.scene = SceneFile(kScene, "s.json").text()}).root["extras"];
  EXPECT_FALSE(extras["sweepkit"].contains("options"));
  EXPECT_EQ(extras["sweepkit"]["scene"]["materials"],
            (json{{"m", json::object()}, {"empty", json::object()}}))
      << "empty objects stay objects";
}

TEST_F(GltfSourceTest, FilesWithoutASceneAreRefused) {
  const std::string lacks = "does not hold the scene that it was made from; give the scene file itself";
  EXPECT_EQ(fault_of(write(make(kScene, "a.glb"))), lacks);
  EXPECT_EQ(fault_of(write("b.gltf", R"({"asset": {"version": "2.0"}, "extras": [1]})")), lacks);
  EXPECT_EQ(fault_of(write("b.gltf", R"({"asset": {"version": "2.0"}, "extras": {"other": 1}})")), lacks);
  EXPECT_EQ(fault_of(folder / "none.glb"), "no such file, or it cannot be read");
  EXPECT_NE(fault_of(write("c.glb", "glTF and no more")).find("is cut short"), std::string::npos);
  EXPECT_NE(fault_of(write("d.glb", "no glTF")).find("not valid JSON"), std::string::npos);
  EXPECT_NE(
      fault_of(write("e.gltf", R"({"extras": {"sweepkit": {"scene": {}, "options": {"bake_size": 0}}}})"))
          .find("at least 1"),
      std::string::npos);
  EXPECT_NE(
      fault_of(write("f.gltf", R"({"extras": {"sweepkit": {"scene": {}, "options": {"look": "lit"}}}})")),
      "");
}

std::string round_trip(const std::string& text) {
  return json_text(parse_json_value(text, "text"));
}

TEST(JsonText, ComesBackTheSame) {
  const std::string text =
      R"({"a":[1,-2.5,1e+300,0.1,-0.0,9007199254740991,1e+16],"b":{},"c":[],"d":"é\"\\\n","e":[true,false,null]})";
  EXPECT_EQ(round_trip(text), text);
  EXPECT_EQ(round_trip(" { \"z\" : 1.0 , // why\n \"a\" : [ ] } "), R"({"z":1,"a":[]})")
      << "keys keep their order";
}

TEST(JsonText, BytesThatAreNoUtf8AreReplaced) {
  EXPECT_EQ(json_text({std::string("a\xff"), {}}), "\"a\xEF\xBF\xBD\"");
  EXPECT_TRUE(is_utf8("é"));
  EXPECT_FALSE(is_utf8("\xff"));
}

TEST(SceneText, HoldsTheSettings) {
  SceneFile scene(
      R"({"$schema": "x", "sweepkit": 1, /* two */ "objects": [{"name": "a", "plane": {"size": [1, 1]}}]})",
      "s.json");
  scene.set({"/objects/0/name", "b"});
  EXPECT_EQ(scene.text(), R"({"sweepkit":1,"objects":[{"name":"b","plane":{"size":[1,1]}}]})");
  const std::vector<Setting> more = {{"/objects/0/plane/size/0", "2"}};
  EXPECT_EQ(scene.text(more), R"({"sweepkit":1,"objects":[{"name":"b","plane":{"size":[2,1]}}]})");
}

}  // namespace
}  // namespace sweepkit::scene
