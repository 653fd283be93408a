// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "sweepkit/scene/gltf_info.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "scene_text.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/model.hpp"

namespace sweepkit::scene {
namespace {

namespace fs = std::filesystem;

class GltfInfoTest : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("sweepkit_" + std::to_string(::getpid()) + info->name());
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void put(const std::string& name, const std::vector<std::byte>& bytes, std::size_t size) const {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(size));
  }
  // Writes a scene with a procedural texture; the .glb or .gltf comes last.
  std::vector<NamedBytes> write_scene(const std::string& name) const {
    const Document document = parse(scene_text(
        R"("textures": {"t": {"procedural": "tiles"}}, "materials": {"m": {"texture": "t"}})",
        kFloor +
            R"(, {"name": "b", "material": "m", "plane": {"size": [1, 1]}, "tessellation": {"contour": 3}})"));
    const Plan plan = scene::plan(document, {.product = Request::Product::kMeshFile});
    GltfFile file = make_gltf(build(document, plan).scene, plan, name, {.bake_size = 8});
    for (const NamedBytes& part : file.files) put(part.name, part.bytes, part.bytes.size());
    return std::move(file.files);
  }

  fs::path folder_;
};

TEST_F(GltfInfoTest, TellsWhatTheWriterWrote) {
  for (const char* name : {"a.glb", "a.gltf"}) {
    write_scene(name);
    const GltfInfo info = read_gltf_info(folder_ / name);
    EXPECT_EQ(info.generator, "sweepkit 0.1.0");
    EXPECT_EQ(info.bytes, fs::file_size(folder_ / name));
    ASSERT_EQ(info.meshes.size(), 2u);
    EXPECT_EQ(info.meshes[0].name, "floor");
    EXPECT_EQ(info.meshes[0].triangles, 2u);
    EXPECT_EQ(info.meshes[0].vertices, 4u);
    EXPECT_EQ(info.meshes[0].material, "default");
    EXPECT_EQ(info.meshes[1].triangles, 6u);
    EXPECT_EQ(info.meshes[1].material, "m");
    ASSERT_EQ(info.materials.size(), 2u);
    EXPECT_FALSE(info.materials[0].is_textured);
    EXPECT_TRUE(info.materials[1].is_textured);
    ASSERT_EQ(info.images.size(), 1u);
    EXPECT_EQ(info.images[0].width, 8);
    EXPECT_EQ(info.images[0].height, 8);
  }
}

// The bytes of the buffer are not looked at, so of the cuts inside it one in 101 is enough.
TEST_F(GltfInfoTest, EveryTruncatedPrefixIsRefused) {
  for (const char* name : {"a.glb", "a.gltf"}) {
    const std::vector<std::byte> whole = write_scene(name).back().bytes;
    const auto end = std::find(whole.rbegin(), whole.rend(), std::byte{'}'});
    const std::size_t size =
        std::string(name) == "a.glb" ? whole.size() : static_cast<std::size_t>(whole.rend() - end);
    for (std::size_t cut = 0; cut < size; cut += cut < 30 || cut + 30 > size ? 1 : 101) {
      put("cut", whole, cut);
      EXPECT_THROW(read_gltf_info(folder_ / "cut"), InputError) << name << " cut at " << cut;
    }
  }
}

TEST_F(GltfInfoTest, DamagedBytesAreReadOrRefused) {
  std::vector<std::byte> bytes = write_scene("a.glb").back().bytes;
  for (std::size_t at = 0; at < bytes.size(); at += at < 30 ? 1 : 37) {
    const std::byte before = std::exchange(bytes[at], std::byte{0xff});
    put("damaged", bytes, bytes.size());
    bytes[at] = before;
    try {
      read_gltf_info(folder_ / "damaged");
    } catch (const InputError&) {
    }
  }
}

// Another program's file, written by hand: quantised, packed, animated, with what should lie beside it not
// there.
const std::string kForeign = R"({
  "asset": {"version": "2.0", "generator": "hand", "copyright": "me"},
  "extensionsUsed": ["KHR_lights_punctual", "EXT_meshopt_compression", "KHR_mesh_quantization"],
  "extensionsRequired": ["KHR_mesh_quantization"],
  "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "name": "lamp", "intensity": 7}, {"type": "point"}]}},
  "extras": {"sweepkit": "a word"},
  "buffers": [{"byteLength": 100, "uri": "not%20there.bin"}, {"byteLength": 240}],
  "bufferViews": [{"buffer": 1, "byteLength": 240, "extensions": {"EXT_meshopt_compression":
      {"buffer": 0, "byteLength": 100, "byteStride": 8, "count": 30, "mode": "ATTRIBUTES"}}}],
  "accessors": [{"componentType": 5122, "type": "VEC3", "count": 30, "bufferView": 0},
                {"componentType": 5120, "type": "VEC3", "count": 30},
                {"componentType": 5123, "type": "SCALAR", "count": 60},
                {"componentType": 5126, "type": "SCALAR", "count": 3, "min": [0], "max": [2.5]},
                {"componentType": 5126, "type": "VEC4", "count": 3}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "_OWN": 1}, "indices": 2,
                              "targets": [{"POSITION": 0}, {"POSITION": 0}]}]}],
  "images": [{"uri": "no.webp", "mimeType": "image/webp"}],
  "textures": [{"source": 0}, {"extensions": {"EXT_texture_webp": {"source": 0}}}],
  "cameras": [{"type": "orthographic", "orthographic": {}}],
  "animations": [{"samplers": [{"input": 3, "output": 4}], "channels": [{"sampler": 0, "target": {"path": "rotation"}}]}]
})";

TEST_F(GltfInfoTest, TellsOfOtherProgramsFilesAndOfWhatIsNotThere) {
  std::ofstream(folder_ / "f.gltf") << kForeign;
  const GltfInfo info = read_gltf_info(folder_ / "f.gltf");
  EXPECT_EQ(info.copyright, "me");
  EXPECT_FALSE(info.has_scene);
  EXPECT_EQ(info.extensions_used.size(), 3u);
  EXPECT_EQ(info.extensions_required, std::vector<std::string>{"KHR_mesh_quantization"});
  ASSERT_EQ(info.lights.size(), 2u);
  EXPECT_EQ(info.lights[0].name, "lamp");
  EXPECT_EQ(info.lights[0].type, "spot");
  EXPECT_EQ(info.lights[0].intensity, 7);
  EXPECT_EQ(info.lights[1].intensity, 1) << "the specification's own";
  ASSERT_EQ(info.buffers.size(), 2u);
  EXPECT_TRUE(info.buffers[0].is_missing);
  EXPECT_EQ(info.buffers[0].file, "not%20there.bin");
  EXPECT_FALSE(info.buffers[1].is_missing) << "it is made by unpacking";
  EXPECT_EQ(info.packed.views, 1u);
  EXPECT_EQ(info.packed.bytes, 100u);
  EXPECT_EQ(info.packed.unpacked_bytes, 240u);
  ASSERT_EQ(info.meshes.size(), 1u);
  EXPECT_EQ(info.meshes[0].triangles, 20u);
  EXPECT_EQ(info.meshes[0].targets, 2u);
  EXPECT_EQ(info.meshes[0].vertex_bytes, 30u * (6 + 3 + 3 + 6 + 6));
  EXPECT_EQ(info.meshes[0].index_bytes, 120u);
  ASSERT_EQ(info.images.size(), 1u);
  EXPECT_TRUE(info.images[0].is_missing);
  EXPECT_EQ(info.images[0].format, "webp");
  ASSERT_EQ(info.textures.size(), 2u);
  EXPECT_EQ(info.textures[0].image, "0");
  EXPECT_EQ(info.textures[1].image, "");
  ASSERT_EQ(info.cameras.size(), 1u);
  EXPECT_EQ(info.cameras[0].type, "orthographic");
  ASSERT_EQ(info.animations.size(), 1u);
  EXPECT_EQ(info.animations[0].seconds, 2.5);
  EXPECT_EQ(info.animations[0].channels, 1u);
}

TEST_F(GltfInfoTest, TellsThatAFileHoldsItsScene) {
  std::ofstream(folder_ / "s.gltf")
      << R"({"asset": {"version": "2.0"}, "extras": {"sweepkit": {"scene": {}}}})";
  EXPECT_TRUE(read_gltf_info(folder_ / "s.gltf").has_scene);
}

}  // namespace
}  // namespace sweepkit::scene
