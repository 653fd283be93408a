// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Images that a program meets and did not expect, by both roads: read whole, and opened to be read piece by
// piece with no memory to spare, so that they stay in their file or are unpacked. Decoded right, or refused
// by name.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "gif.hpp"
#include "jpeg.hpp"
#include "png.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_file.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"
#include "tiff.hpp"

namespace sweepkit::texmap {
namespace {

enum class Road { kWhole, kPieces };

// The texels of a file, read by one road.
class Texels {
 public:
  Texels(const std::filesystem::path& file, ColorSpace color_space, Road road)
      : info_(read_image_info(file)) {
    if (road == Road::kWhole) {
      texture_.image = std::make_shared<const Image>(read_image(file, color_space));
    } else {
      texture_.file = open_image(file, color_space, 64);  // no image of more than 16 bytes is read whole
    }
    sampler_.emplace(texture_, Filter::kPoint, cache_, 0);
  }
  int width() const { return info_.width; }
  int height() const { return info_.height; }
  glm::vec3 at(int x, int y) {
    FilterThread thread(cache_);
    const glm::dvec2 uv((x + 0.5) / width(), 1 - (y + 0.5) / height());
    return sampler_->sample({uv, {}, {}}, thread);
  }

 private:
  ImageFileInfo info_;
  ImageTexture texture_;
  TileCache cache_;
  std::optional<TextureSampler> sampler_;
};

class OddImage : public testing::TestWithParam<Road> {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("sweepkit_odd_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, std::span<const std::byte> bytes) const {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return folder_ / name;
  }
  Texels read(const std::string& name, std::span<const std::byte> bytes,
              ColorSpace color_space = ColorSpace::kLinear) const {
    return {write(name, bytes), color_space, GetParam()};
  }
  // What is said about a file, every texel looked at.
  std::string message(const std::string& name, std::span<const std::byte> bytes) const {
    try {
      Texels texels = read(name, bytes);
      for (int y = 0; y < texels.height(); ++y) {
        for (int x = 0; x < texels.width(); ++x) texels.at(x, y);
      }
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  void expect_refused(const std::string& name, std::span<const std::byte> bytes) const {
    const std::string text = message(name, bytes);
    EXPECT_EQ(text.find((folder_ / name).string() + ": cannot be read as an image: "), 0u) << text;
  }

  std::filesystem::path folder_;
};

INSTANTIATE_TEST_SUITE_P(Road, OddImage, testing::Values(Road::kWhole, Road::kPieces), [](const auto& road) {
  return std::string(road.param == Road::kWhole ? "Whole" : "Pieces");
});

// Within float32's rounding of a texel.
void expect_near(const glm::vec3& got, const glm::vec3& want) {
  EXPECT_LT(glm::length(got - want), 1e-6f) << got.x << " " << got.y << " " << got.z;
}

std::vector<std::byte> bytes_of(std::initializer_list<int> values) {
  std::vector<std::byte> bytes;
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

std::vector<std::byte> floats_of(std::span<const float> values) {
  const auto bytes = std::as_bytes(values);
  return {bytes.begin(), bytes.end()};
}

std::span<const std::byte> front(const std::vector<std::byte>& bytes, std::size_t count) {
  return std::span(bytes).first(count);
}

TEST_P(OddImage, TruncatedIsRefused) {
  const std::vector<std::uint8_t> rows(3 * 8 * 8, 77);
  const std::vector<std::byte> png = make_png({8, 8}, rows);
  for (const std::size_t length : {png.size() / 4, png.size() / 2, png.size() - 20})
    expect_refused("cut.png", front(png, length));
  // Of a tiled file what is missing shows when it is read: the directory stands before the texels here.
  const std::vector<std::byte> tiles(2 * 16 * 16, std::byte{99});
  std::vector<std::byte> tiff = make_tiff({.width = 32, .height = 16, .tile = 16}, tiles);
  EXPECT_EQ(message("whole.tif", tiff), "no error");
  for (const std::size_t length : {std::size_t{100}, std::size_t{8 + 300}, tiff.size() - 8})
    expect_refused("cut.tif", front(tiff, length));
  const std::vector<std::byte> jpeg = make_cmyk_jpeg({10, 200, 30, 40});
  for (const std::size_t length : {std::size_t{60}, std::size_t{160}, jpeg.size() - 6})
    expect_refused("cut.jpg", front(jpeg, length));
}

TEST_P(OddImage, WithoutPixelsIsRefused) {
  const std::vector<std::uint8_t> row(3);
  for (const PngHeader& header : {PngHeader{0, 1}, PngHeader{1, 0}, PngHeader{0, 0}})
    expect_refused("zero.png", make_png(header, row));
  expect_refused("zero.tif", make_tiff({.width = 0, .height = 4}, bytes_of({1, 2, 3, 4})));
  expect_refused("zero.tif", make_tiff({.width = 4, .height = 0}, bytes_of({1, 2, 3, 4})));
  expect_refused("empty.png", {});
}

TEST_P(OddImage, OfOneBitIsBlackAndWhite) {
  // 17 pixels: the last byte of a row is used in part.
  const std::vector<std::uint8_t> rows = {0b10100000, 0b00000001, 0b10000000};
  Texels png = read("bits.png", make_png({17, 1, 1, 0}, rows));
  Texels tiff = read("bits.tif", make_tiff({.width = 17, .bits = 1}, std::as_bytes(std::span(rows))));
  Texels inverse = read(
      "inverse.tif", make_tiff({.width = 17, .bits = 1, .photometric = 0}, std::as_bytes(std::span(rows))));
  for (int x = 0; x < 17; ++x) {
    const float value = x == 0 || x == 2 || x == 15 || x == 16 ? 1.0f : 0.0f;
    expect_near(png.at(x, 0), glm::vec3(value));
    expect_near(tiff.at(x, 0), glm::vec3(value));
    expect_near(inverse.at(x, 0), glm::vec3(1 - value));
  }
}

TEST_P(OddImage, OfInksIsMadeRgb) {
  // R = (1 - C) (1 - K) and so on: what every reader without a colour profile does.
  Texels tiff =
      read("inks.tif", make_tiff({.width = 5, .channels = 4, .photometric = 5},
                                 bytes_of({0,  0,   0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0,  //
                                           51, 102, 0, 51})));
  expect_near(tiff.at(0, 0), glm::vec3(1, 1, 1));
  expect_near(tiff.at(1, 0), glm::vec3(0, 1, 1));
  expect_near(tiff.at(2, 0), glm::vec3(1, 0, 1));
  expect_near(tiff.at(3, 0), glm::vec3(1, 1, 0));
  // 0.8 and 0.6 times 0.8, in 8 bits by a reader that cuts or rounds.
  const glm::vec3 mixed = tiff.at(4, 0);
  EXPECT_LT(glm::length(mixed - glm::vec3(0.64f, 0.48f, 0.8f)), 1.8f / 255) << mixed.x << " " << mixed.y;
  Texels jpeg = read("inks.jpg", make_cmyk_jpeg({204, 153, 255, 204}));
  for (const int place : {0, 7})
    EXPECT_LT(glm::length(jpeg.at(place, 7 - place) - glm::vec3(0.64f, 0.48f, 0.8f)), 3.5f / 255)
        << jpeg.at(place, 7 - place).x << " " << jpeg.at(place, 7 - place).y;
}

TEST_P(OddImage, OfSixteenBitsKeepsTheLast) {
  std::vector<std::uint8_t> big_endian;
  std::vector<std::uint8_t> little_endian;
  for (int i = 0; i < 3 * 16; ++i) {
    const int value = 1361 * i + 7;
    big_endian.insert(big_endian.end(),
                      {static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)});
    little_endian.insert(little_endian.end(),
                         {static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value >> 8)});
  }
  Texels png = read("deep.png", make_png({16, 1, 16, 2}, big_endian));
  Texels tiff = read("deep.tif", make_tiff({.width = 16, .channels = 3, .bits = 16, .photometric = 2},
                                           std::as_bytes(std::span(little_endian))));
  for (int x = 0; x < 16; ++x) {
    const glm::vec3 want = (1361.0f * (glm::vec3(0, 1, 2) + 3.0f * static_cast<float>(x)) + 7.0f) / 65535.0f;
    expect_near(png.at(x, 0), want);  // 1e-6 is a fifteenth of the last bit
    expect_near(tiff.at(x, 0), want);
  }
}

TEST_P(OddImage, WithNanOrInfinityIsRefusedWithTheirPlace) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    std::vector<float> strip(20 * 4, 0.5f);
    strip[2 * 20 + 7] = bad;
    EXPECT_EQ(message("nan.tif",
                      make_tiff({.width = 20, .height = 4, .bits = 32, .is_float = true}, floats_of(strip))),
              (folder_ / "nan.tif").string() + ": has NaN or infinity at pixel (7, 2); mend the image");
    // In the second of two tiles.
    std::vector<float> tiles(2 * 16 * 16, 0.5f);
    tiles[16 * 16 + 3 * 16 + 5] = bad;
    EXPECT_EQ(
        message("nan.tif", make_tiff({.width = 32, .height = 16, .bits = 32, .is_float = true, .tile = 16},
                                     floats_of(tiles))),
        (folder_ / "nan.tif").string() + ": has NaN or infinity at pixel (21, 3); mend the image");
  }
}

TEST_P(OddImage, OfManyFramesGivesTheFirst) {
  const std::array<std::array<std::uint8_t, 3>, 4> colors = {
      {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}}};
  const std::vector<std::vector<std::uint8_t>> frames = {
      {0, 1, 2, 3, 0, 2}, {3, 3, 3, 3, 3, 3}, {1, 1, 1, 1, 1, 1}};
  Texels gif = read("moving.gif", make_gif(3, 2, colors, frames));
  EXPECT_EQ(gif.width(), 3);
  EXPECT_EQ(gif.height(), 2);
  for (int i = 0; i < 6; ++i) {
    const auto& color = colors[frames[0][static_cast<std::size_t>(i)]];
    expect_near(gif.at(i % 3, i / 3), glm::vec3(color[0], color[1], color[2]) / 255.0f);
  }
}

TEST_P(OddImage, OfAHundredThousandColumnsIsReadToTheLast) {
  constexpr int kWidth = 100'000;
  std::vector<std::uint8_t> bits(2 * kWidth / 8);
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = static_cast<std::uint8_t>(i * 37 + i / 251);
  Texels png = read("wide.png", make_png({kWidth, 2, 1, 0}, bits));
  // Rows of tiles that end inside the last one.
  std::vector<std::byte> bytes;
  for (int tile = 0; tile < (kWidth + 15) / 16; ++tile) {
    for (int i = 0; i < 256; ++i) bytes.push_back(static_cast<std::byte>(tile * 7 + i % 16 * 3 + i / 16));
  }
  Texels tiff = read("wide.tif", make_tiff({.width = kWidth, .height = 2, .tile = 16}, bytes));
  for (const int x : {0, 1, 63, 64, 32'767, 32'768, 65'535, 65'536, 99'998, 99'999}) {
    for (const int y : {0, 1}) {
      const int bit = y * kWidth + x;
      expect_near(
          png.at(x, y),
          glm::vec3((bits[static_cast<std::size_t>(bit / 8)] >> (7 - bit % 8) & 1) != 0 ? 1.0f : 0.0f));
      const int value = (x / 16 * 7 + x % 16 * 3 + y) & 255;
      expect_near(tiff.at(x, y), glm::vec3(static_cast<float>(value) / 255.0f));
    }
  }
}

}  // namespace
}  // namespace sweepkit::texmap
