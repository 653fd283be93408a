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

}  // namespace
}  // namespace sweepkit::scene
