// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Which images a glTF holds, where, and when a file is copied instead of encoded again.

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "image_header.hpp"
#include "parsed_gltf.hpp"
#include "sweepkit/scene/image_store.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::scene {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

// A folder with images, gone at the end.
class GltfImagesTest : public testing::Test {
 protected:
  GltfImagesTest() : folder(fs::path(testing::TempDir()) / ("images_" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
  }
  ~GltfImagesTest() override { fs::remove_all(folder); }

  void write(const std::string& name, const Bytes& bytes) const {
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  static texmap::Image gradient(int width = 48, int height = 32) {
    texmap::Image image{width, height, 3, std::vector<std::uint16_t>()};
    auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        texels.push_back(static_cast<std::uint16_t>(x * 1300));
        texels.push_back(static_cast<std::uint16_t>(y * 1900));
        texels.push_back(30000);
      }
    }
    return image;
  }

  Bytes save(const std::string& name, texmap::ImageFormat format, int width = 48) const {
    const Bytes bytes = texmap::encode_image(gradient(width), format);
    write(name, bytes);
    return bytes;
  }

  // A plane with each of these textures.
  std::string textured(const std::vector<std::string>& textures) const {
    std::string entries;
    std::string materials;
    std::string objects;
    for (std::size_t i = 0; i < textures.size(); ++i) {
      const std::string n = std::to_string(i);
      const std::string comma = i > 0 ? ", " : "";
      entries += comma + "\"t" + n + "\": " + textures[i];
      materials += comma + "\"m" + n + R"(": {"texture": "t)" + n + "\"}";
      objects +=
          comma + R"({"name": "o)" + n + R"(", "material": "m)" + n + R"(", "plane": {"size": [1, 1]}})";
    }
    return scene_text("\"textures\": {" + entries + "}, \"materials\": {" + materials + "}", objects);
  }

  static std::string image(const std::string& name, const std::string& more = "") {
    return R"({"image": ")" + name + "\"" + more + "}";
  }

  GltfFile file(const std::string& text, const std::string& name, const GltfOptions& options = {}) const {
    const Document document = parse_document(text, folder / "s.json");
    const Plan needs = plan(document, {.product = Request::Product::kMeshFile});
    return make_gltf(build(document, needs).scene, needs, name, options);
  }

  // What stands beside a .gltf, without the buffer and the file itself.
  std::vector<NamedBytes> beside(const std::string& text, const GltfOptions& options = {}) const {
    std::vector<NamedBytes> files = file(text, "s.gltf", options).files;
    files.resize(files.size() - 2);
    return files;
  }

  const fs::path folder;
};

TEST_F(GltfImagesTest, AFileThatNeedsNoChangeIsCopied) {
  const Bytes png = save("a.png", texmap::ImageFormat::kPng);
  const Bytes jpeg = save("b.JPG", texmap::ImageFormat::kJpeg);
  const auto files = beside(textured({image("a.png"), image("b.JPG")}));
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].name, "s_0.png");
  EXPECT_EQ(files[0].bytes, png);
  EXPECT_EQ(files[1].name, "s_1.jpg");
  EXPECT_EQ(files[1].bytes, jpeg);
}

TEST_F(GltfImagesTest, WhatNeedsAChangeIsEncodedAsPng) {
  save("a.tif", texmap::ImageFormat::kTiff);
  const Bytes png = save("b.png", texmap::ImageFormat::kPng);
  const auto files = beside(textured({image("a.tif"), image("b.png", R"(, "color_space": "linear")")}));
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].bytes,
            texmap::encode_image(texmap::read_image(folder / "a.tif", texmap::ColorSpace::kSrgb),
                                 texmap::ImageFormat::kPng));
  EXPECT_NE(files[1].bytes, png) << "glTF's colours are sRGB";
}

// An Exif segment that says: turned by a quarter.
TEST_F(GltfImagesTest, AJpegThatExifTurnsIsNotCopied) {
  Bytes jpeg = save("a.jpg", texmap::ImageFormat::kJpeg);
  const std::string segment(
      "\xff\xe1\0\x22"
      "Exif\0\0II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0",
      36);
  const auto bytes = std::as_bytes(std::span(segment));
  jpeg.insert(jpeg.begin() + 2, bytes.begin(), bytes.end());
  write("a.jpg", jpeg);
  ASSERT_EQ(image_header(jpeg)->orientation, 6);
  const auto files = beside(textured({image("a.jpg")}));
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].name, "s_0.png");
}

TEST_F(GltfImagesTest, TheFormatAskedForIsThatOfAll) {
  const Bytes png = save("a.png", texmap::ImageFormat::kPng);
  const Bytes jpeg = save("b.jpg", texmap::ImageFormat::kJpeg, 40);
  const std::string text = textured({image("a.png"), image("b.jpg")});
  const auto as_jpeg = beside(text, {.image_format = texmap::ImageFormat::kJpeg});
  ASSERT_EQ(as_jpeg.size(), 2u);
  EXPECT_EQ(as_jpeg[0].name, "s_0.jpg");
  EXPECT_EQ(as_jpeg[0].bytes,
            texmap::encode_image(texmap::read_image(folder / "a.png", texmap::ColorSpace::kSrgb),
                                 texmap::ImageFormat::kJpeg));
  EXPECT_EQ(as_jpeg[1].bytes, jpeg);
  const auto as_png = beside(text, {.image_format = texmap::ImageFormat::kPng});
  ASSERT_EQ(as_png.size(), 2u);
  EXPECT_EQ(as_png[0].bytes, png);
  EXPECT_EQ(as_png[1].name, "s_1.png");
}

TEST_F(GltfImagesTest, ContainersHoldImagesWhereTheyAreAskedFor) {
  const Bytes png = save("a.png", texmap::ImageFormat::kPng);
  const std::string text = textured({image("a.png")});
  const GltfFile glb = file(text, "s.glb", {.images_in = GltfImages::kSeparate});
  ASSERT_EQ(glb.files.size(), 2u);
  EXPECT_EQ(glb.files[0].name, "s_0.png");
  EXPECT_EQ(glb.files[0].bytes, png);
  EXPECT_EQ(glb.files[1].name, "s.glb");
  const GltfFile gltf = file(text, "s.gltf", {.images_in = GltfImages::kEmbedded});
  ASSERT_EQ(gltf.files.size(), 2u);
  EXPECT_EQ(gltf.files[0].name, "s.bin");
  const auto& text_bytes = gltf.files[1].bytes;
  const auto* first = reinterpret_cast<const char*>(text_bytes.data());
  const json root = json::parse(first, first + text_bytes.size());
  EXPECT_EQ(root["images"][0]["mimeType"], "image/png");
  const json& view = root["bufferViews"][root["images"][0]["bufferView"].get<std::size_t>()];
  EXPECT_TRUE(std::equal(png.begin(), png.end(),
                         gltf.files[0].bytes.begin() + view.value("byteOffset", std::ptrdiff_t{0})));
}

TEST_F(GltfImagesTest, EqualImagesAreOne) {
  save("a.png", texmap::ImageFormat::kPng);
  fs::copy_file(folder / "a.png", folder / "copy.png");
  const GltfFile made =
      file(textured({image("a.png"), image("copy.png"), image("a.png", R"(, "wrap": "clamp")"),
                     R"({"procedural": "checker"})", R"({"procedural": "checker"})"}),
           "s.gltf", {.bake_size = 16});
  const auto& text = made.files.back().bytes;
  const auto* first = reinterpret_cast<const char*>(text.data());
  const json root = json::parse(first, first + text.size());
  EXPECT_EQ(root["images"].size(), 2u);
  EXPECT_EQ(root["textures"].size(), 3u) << "an image repeated, the same clamped, the checker";
  EXPECT_EQ(root["materials"].size(), 3u);
  EXPECT_EQ(made.files.size(), 4u);
}

TEST_F(GltfImagesTest, LargerImagesAreMadeSmallerInLinearLight) {
  // A chessboard of black and white texels: half the light is sRGB 188, not 128.
  texmap::Image board{64, 64, 3, std::vector<std::uint16_t>()};
  for (int i = 0; i < 64 * 64; ++i) {
    const std::uint16_t value = (i / 64 + i % 64) % 2 == 0 ? 0 : 65535;
    for (int c = 0; c < 3; ++c) std::get<std::vector<std::uint16_t>>(board.texels).push_back(value);
  }
  write("board.png", texmap::encode_image(board, texmap::ImageFormat::kPng));
  const auto files = beside(textured({image("board.png")}), {.max_texture = 16});
  write("small.png", files.at(0).bytes);
  const texmap::Image small = texmap::read_image(folder / "small.png", texmap::ColorSpace::kLinear);
  EXPECT_EQ(small.width, 16);
  EXPECT_EQ(small.height, 16);
  EXPECT_NEAR(small.color(7, 7).g * 255, 188, 0.01);

  const Bytes fits = save("fits.png", texmap::ImageFormat::kPng, 16);
  EXPECT_EQ(beside(textured({image("fits.png")}), {.max_texture = 32}).at(0).bytes, fits);
}

TEST_F(GltfImagesTest, BakesAreNoLargerThanImagesMayBe) {
  const auto files = beside(textured({R"({"procedural": "marble"})", R"({"procedural": "checker"})"}),
                            {.bake_size = 64, .max_texture = 16});
  ASSERT_EQ(files.size(), 2u);
  for (const NamedBytes& one : files) EXPECT_EQ(image_header(one.bytes)->width, 16);
}

TEST_F(GltfImagesTest, AStoreChangesNothing) {
  save("a.png", texmap::ImageFormat::kPng);
  save("b.tif", texmap::ImageFormat::kTiff);
  const std::string text = textured({image("a.png"), image("b.tif")});
  const Document document = parse_document(text, folder / "s.json");
  const Plan needs = plan(document, {.product = Request::Product::kMeshFile});
  ImageStore store;
  for (const int most : {0, 20, 0}) {
    const GltfOptions options{.max_texture = most, .images = &store};
    const GltfFile stored = make_gltf(build(document, needs, &store).scene, needs, "s.glb", options);
    EXPECT_EQ(stored.files[0].bytes, file(text, "s.glb", {.max_texture = most}).files[0].bytes) << most;
  }
}

TEST_F(GltfImagesTest, AnImageThatCannotBeReadIsNamed) {
  write("a.png", Bytes(20));
  try {
    file(textured({image("a.png")}), "s.glb");
    FAIL() << "no image was taken for one";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a.png"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sweepkit::scene
