// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "sweepkit/scene/image_store.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "scene_text.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/texmap/bake.hpp"

namespace sweepkit::scene {
namespace {

namespace fs = std::filesystem;
constexpr auto kSrgb = texmap::ColorSpace::kSrgb;
const fs::path kBands = SWEEPKIT_SAMPLES "/textures/vase_bands.png";
const fs::path kTiles = SWEEPKIT_SAMPLES "/textures/floor_tiles.png";

TEST(ImageStore, ReadsAFileOnceForEachColorSpace) {
  ImageStore store;
  const StoredImage first = store.read(kBands, kSrgb);
  const StoredImage again = store.read(kBands, kSrgb);
  const StoredImage linear = store.read(kBands, texmap::ColorSpace::kLinear);
  EXPECT_TRUE(first.is_new);
  EXPECT_FALSE(again.is_new);
  EXPECT_EQ(first.image, again.image);
  EXPECT_TRUE(linear.is_new);
  EXPECT_EQ(first.image->texels, texmap::read_image(kBands, kSrgb).texels);
  EXPECT_EQ(linear.image->texels, texmap::read_image(kBands, texmap::ColorSpace::kLinear).texels);
}

TEST(ImageStore, BakesAProceduralOnceForEachValueAndSize) {
  ImageStore store;
  const texmap::Procedural checker{.scale = 2};
  const StoredImage first = store.bake(checker, {16, 16});
  EXPECT_TRUE(first.is_new);
  EXPECT_EQ(store.bake(checker, {16, 16}).image, first.image);
  EXPECT_EQ(store.bake(checker, {8, 8}).image->width, 8);
  EXPECT_TRUE(store.bake({.scale = 4}, {16, 16}).is_new);
  EXPECT_EQ(first.image->texels, texmap::bake(checker, {}, {16, 16}).image.texels);
}

TEST(ImageStore, EncodesItsOwnImagesOnceAndTakesThoseOfOthers) {
  ImageStore store;
  const StoredImage own = store.read(kBands, kSrgb);
  EXPECT_EQ(store.encoded(own.image), store.encoded(own.image)) << "the same bytes, not equal ones";
  EXPECT_EQ(*store.encoded(own.image), texmap::encode_image(*own.image, texmap::ImageFormat::kPng));
  const auto other = std::make_shared<const texmap::Image>(texmap::read_image(kBands, kSrgb));
  EXPECT_NE(store.encoded(other), store.encoded(own.image));
  EXPECT_EQ(*store.encoded(other), *store.encoded(own.image));
}

TEST(ImageStore, AFaultIsToldToEveryoneWhoAsksAndAMendedFileIsRead) {
  const fs::path file = fs::path(testing::TempDir()) / ("store_" + std::to_string(::getpid()) + ".png");
  ImageStore store;
  EXPECT_THROW(store.read(file, kSrgb), InputError);
  EXPECT_THROW(store.read(file, kSrgb), InputError);
  fs::copy_file(kBands, file);
  EXPECT_TRUE(store.read(file, kSrgb).is_new);
  fs::remove(file);
  EXPECT_FALSE(store.read(file, kSrgb).is_new);
}

TEST(ImageStore, LetsTheOldestGoWhenItIsFull) {
  const std::size_t bands = texmap::read_image(kBands, kSrgb).bytes();
  const std::size_t tiles = texmap::read_image(kTiles, kSrgb).bytes();
  ImageStore store(bands + tiles - 1);
  const StoredImage held = store.read(kBands, kSrgb);
  EXPECT_TRUE(store.read(kTiles, kSrgb).is_new);
  EXPECT_FALSE(store.read(kTiles, kSrgb).is_new);
  EXPECT_FALSE(store.encoded(held.image)->empty()) << "what was let go is still whole for who holds it";
  EXPECT_TRUE(store.read(kBands, kSrgb).is_new);

  ImageStore nothing(0);
  EXPECT_TRUE(nothing.read(kBands, kSrgb).is_new);
  EXPECT_TRUE(nothing.read(kBands, kSrgb).is_new);
}

TEST(ImageStore, KeepsAThousandImagesHoweverSmall) {
  ImageStore store;
  const auto bake = [&](int i) { return store.bake({.scale = 1.0 * i}, {1, 1}); };
  for (int i = 1; i <= 1000; ++i) ASSERT_TRUE(bake(i).is_new);
  EXPECT_FALSE(bake(1).is_new);
  EXPECT_TRUE(bake(1001).is_new);
  EXPECT_FALSE(bake(2).is_new);
  EXPECT_TRUE(bake(1).is_new) << "the oldest has made room";
}

TEST(ImageStore, ManyThreadsThatWantOneImageGetItFromOneRead) {
  ImageStore store;
  std::vector<StoredImage> images(8);
  std::vector<std::shared_ptr<const std::vector<std::byte>>> encoded(images.size());
  std::vector<std::thread> threads;
  threads.reserve(images.size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    threads.emplace_back([&, i] {
      images[i] = store.read(kBands, kSrgb);
      encoded[i] = store.encoded(images[i].image);
    });
  }
  for (std::thread& thread : threads) thread.join();
  int reads = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    reads += images[i].is_new;
    EXPECT_EQ(images[i].image, images[0].image);
    EXPECT_EQ(encoded[i], encoded[0]);
  }
  EXPECT_EQ(reads, 1);
}

// Image, repeating procedural and one that is baked for its surface: with a store the second file costs only
// the last again, and both files are the ones made without it.
TEST(ImageStore, MakesTheSameFilesForLess) {
  const std::string text = scene_text(
      R"("textures": {"image": {"image": "textures/vase_bands.png"}, "checks": {"procedural": "checker"},
         "stone": {"procedural": "marble"}},
         "materials": {"i": {"texture": "image"}, "c": {"texture": "checks"}, "s": {"texture": "stone"}})",
      R"({"name": "i", "material": "i", "plane": {"size": [1, 1]}},
         {"name": "c", "material": "c", "plane": {"size": [1, 1]}},
         {"name": "s", "material": "s", "plane": {"size": [1, 1]}})");
  const Document document = parse_document(text, SWEEPKIT_SAMPLES "/s.json");
  const Plan needs = plan(document, {.product = Request::Product::kMeshFile});
  const auto make = [&](ImageStore* store) {
    const Model model = build(document, needs, store);
    GltfFile file = make_gltf(model.scene, needs, "s.glb", {.bake_size = 16, .images = store});
    file.ledger.add(model.ledger);
    return file;
  };
  const GltfFile alone = make(nullptr);
  ImageStore store;
  const GltfFile first = make(&store);
  const GltfFile second = make(&store);
  EXPECT_EQ(first.files[0].bytes, alone.files[0].bytes);
  EXPECT_EQ(second.files[0].bytes, alone.files[0].bytes);
  EXPECT_EQ(first.ledger[Part::kTextures].bytes, alone.ledger[Part::kTextures].bytes);
  EXPECT_EQ(second.ledger[Part::kTextures].bytes, 0u) << "the image is not read again";
  EXPECT_EQ(first.ledger[Part::kBakes].calls, 2u);
  EXPECT_EQ(second.ledger[Part::kBakes].calls, 1u) << "the marble lies on its own surface";
}

}  // namespace
}  // namespace sweepkit::scene
