// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/file_image.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>

#include "gif.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::texmap {
namespace {

class FileImageTest : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("sweepkit_file_image_" + std::to_string(getpid()) + info->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::vector<std::byte>& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return folder_ / name;
  }

  std::filesystem::path folder_;
};

constexpr std::array kFormats = {ImageFormat::kPng, ImageFormat::kJpeg, ImageFormat::kTiff,
                                 ImageFormat::kExr};

// Numbers over [0, 1] and a little beyond, different in every channel.
Image ramp(int channels) {
  Image image = make_float_image(24, 10, channels);
  auto& texels = std::get<std::vector<float>>(image.texels);
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = static_cast<float>((37 * i + 11) % texels.size()) / static_cast<float>(texels.size()) * 1.1f;
  return image;
}

// The curve of IEC 61966-2-1 in 64-bit mantissas, and the level that is nearest.
long srgb_level(float linear, int most) {
  const auto x = static_cast<long double>(linear);
  const long double encoded = x <= 0.0031308L ? 12.92L * x : 1.055L * std::pow(x, 1 / 2.4L) - 0.055L;
  return std::lround(static_cast<long double>(most) * encoded);
}

TEST(Srgb, EveryLevelIsTheNearestToTheCurve) {
  // All 16-bit levels of light, and floats between them down to where the curve is straight.
  Image image = make_float_image(65536, 2, 1);
  auto& texels = std::get<std::vector<float>>(image.texels);
  for (std::size_t i = 0; i < 65536; ++i) {
    texels[i] = static_cast<float>(i) / 65535;
    texels[65536 + i] = std::exp2(-static_cast<float>(i) / 4096);
  }
  const FileImage eight = to_file_image(image, {});
  const FileImage sixteen = to_file_image(image, {.bits = 16});
  for (std::size_t i = 0; i < texels.size(); ++i) {
    ASSERT_EQ(std::get<0>(eight.samples)[i], srgb_level(texels[i], 255)) << texels[i];
    // Double rounds the curve to 2^-52, which is 4e-12 of a level: as good as never on the other side of a
    // half. None of these numbers is.
    ASSERT_EQ(std::get<1>(sixteen.samples)[i], srgb_level(texels[i], 65535)) << texels[i];
  }
}

TEST(ToFileImage, ClampsToWhatTheFormatHoldsAndWritesNoNan) {
  Image image = make_float_image(2, 2, 1);
  std::get<std::vector<float>>(image.texels) = {std::nanf(""), -HUGE_VALF, HUGE_VALF, 1e6f};
  EXPECT_EQ(std::get<0>(to_file_image(image, {}).samples), (std::vector<std::uint8_t>{0, 0, 255, 255}));
  EXPECT_EQ(std::get<1>(to_file_image(image, {.bits = 16}).samples),
            (std::vector<std::uint16_t>{0, 0, 65535, 65535}));
  EXPECT_EQ(std::get<2>(to_file_image(image, {.format = ImageFormat::kExr}).samples),
            (std::vector<float>{0, -65504, 65504, 65504}));
  constexpr float kMost = std::numeric_limits<float>::max();
  EXPECT_EQ(std::get<2>(to_file_image(image, {.format = ImageFormat::kExr, .bits = 32}).samples),
            (std::vector<float>{0, -kMost, kMost, 1e6f}));
}

TEST(ToFileImage, KeepsAlphaLinearAndLeavesItOutOfJpeg) {
  Image image = make_float_image(1, 1, 4);
  std::get<std::vector<float>>(image.texels) = {0.5f, 0.5f, 0.5f, 0.5f};
  const FileImage png = to_file_image(image, {});
  EXPECT_EQ(std::get<0>(png.samples), (std::vector<std::uint8_t>{188, 188, 188, 128}));
  EXPECT_EQ(png.channels.back().name, "A");
  EXPECT_EQ(to_file_image(image, {.format = ImageFormat::kJpeg}).channels.size(), 3u);
}

TEST(HoldsBits, IsWhatTheFormatsHave) {
  for (const ImageFormat format : kFormats) {
    const bool is_exr = format == ImageFormat::kExr;
    EXPECT_EQ(holds_bits(format, 8), !is_exr);
    EXPECT_EQ(holds_bits(format, 16), format != ImageFormat::kJpeg);
    EXPECT_EQ(holds_bits(format, 32), is_exr);
    EXPECT_FALSE(holds_bits(format, 12));
  }
}

TEST_F(FileImageTest, ReadBackIsWhatWasWrittenAtEveryDepth) {
  for (const ImageFormat format : {ImageFormat::kPng, ImageFormat::kTiff, ImageFormat::kExr}) {
    for (const int bits : {8, 16, 32}) {
      if (!holds_bits(format, bits)) continue;
      for (const int channels : {1, 3, 4}) {
        FileImage image = to_file_image(ramp(channels), {.format = format, .bits = bits});
        const auto file = write("a", encode_file(image));
        const FileImage back = read_file_image(file);
        EXPECT_EQ(back.width, image.width);
        EXPECT_EQ(back.height, image.height);
        EXPECT_EQ(back.format, format);
        ASSERT_EQ(back.channels, image.channels) << channels << " channels of " << bits << " bits";
        if (format == ImageFormat::kExr && bits == 16) {
          // 11 bits of mantissa, rounded to nearest.
          for (std::size_t i = 0; i < std::get<2>(image.samples).size(); ++i) {
            const float value = std::get<2>(image.samples)[i];
            EXPECT_NEAR(std::get<2>(back.samples)[i], value, std::max(std::ldexp(value, -11), 0x1p-25f));
          }
        } else {
          EXPECT_EQ(back.samples, image.samples) << channels << " channels of " << bits << " bits";
        }
        EXPECT_EQ(encode_file(back), encode_file(image)) << "written again";
      }
    }
  }
}

TEST_F(FileImageTest, TheDescriptionStaysInEveryFormat) {
  for (const ImageFormat format : kFormats) {
    FileImage image = to_file_image(ramp(3), {.format = format});
    const auto without = write("without", encode_file(image));
    EXPECT_EQ(read_description(without), "");
    image.description = "sweepkit-picture key=0123 size=24x10 tile=1/2";
    const auto file = write("with", encode_file(image));
    EXPECT_EQ(read_description(file), image.description);
    EXPECT_EQ(read_file_image(file).description, image.description);
  }
  EXPECT_EQ(read_description(folder_ / "none.png"), "");
  EXPECT_EQ(read_description(folder_), "");
  EXPECT_EQ(read_description(write("text.png", std::vector<std::byte>(100))), "");
}

TEST_F(FileImageTest, AnExrKeepsItsPlaceInALargerPicture) {
  FileImage image = to_file_image(ramp(3), {.format = ImageFormat::kExr});
  image.window = {5, 7, 100, 80};
  const FileImage back = read_file_image(write("a.exr", encode_file(image)));
  EXPECT_EQ(back.window.x, 5);
  EXPECT_EQ(back.window.y, 7);
  EXPECT_EQ(back.window.full_width, 100);
  EXPECT_EQ(back.window.full_height, 80);
  EXPECT_EQ(back.width, 24);
  EXPECT_EQ(encode_file(back), encode_file(image));
  // As a texture it is its own pixels alone.
  EXPECT_EQ(read_image(folder_ / "a.exr", ColorSpace::kLinear).width, 24);
}

TEST_F(FileImageTest, LayersAreChannelsOfAnExrAtFullPrecision) {
  Image depth = make_float_image(24, 10, 1);
  std::get<std::vector<float>>(depth.texels)[13] = 16777215;  // no half
  const Image normal = ramp(3);
  const std::array layers = {ImageLayer{{"normal.X", "normal.Y", "normal.Z"}, &normal},
                             ImageLayer{{"depth.Z"}, &depth}};
  const FileImage image = to_file_image(ramp(4), {.format = ImageFormat::kExr, .bits = 16, .layers = layers});
  const FileImage back = read_file_image(write("a.exr", encode_file(image)));
  ASSERT_EQ(back.channels.size(), 8u);
  for (const FileChannel& channel : back.channels) {
    const auto same = std::find(image.channels.begin(), image.channels.end(), channel);
    ASSERT_NE(same, image.channels.end()) << channel.name << " " << channel.bits;
    const auto from = static_cast<std::size_t>(same - image.channels.begin());
    const auto to = static_cast<std::size_t>(&channel - back.channels.data());
    for (std::size_t texel = 0; texel < 240 && channel.bits == 32; ++texel)
      EXPECT_EQ(std::get<2>(back.samples)[8 * texel + to], std::get<2>(image.samples)[8 * texel + from]);
  }
  EXPECT_EQ(encode_file(back), encode_file(image));
}

TEST_F(FileImageTest, RefusesWhatItDoesNotWriteItself) {
  const std::array<std::array<std::uint8_t, 3>, 4> colors{};
  const std::vector<std::vector<std::uint8_t>> frames = {std::vector<std::uint8_t>(4)};
  const auto file = write("a.gif", make_gif(2, 2, colors, frames));
  try {
    read_file_image(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(),
              file.string() + ": cannot be read as an image: it is no PNG, JPEG, TIFF or EXR file");
  }
  EXPECT_THROW(read_file_image(folder_ / "none.png"), InputError);
  FileImage many{.width = 1, .height = 1, .format = ImageFormat::kExr};
  for (int i = 0; i < 65; ++i) many.channels.push_back({"c" + std::to_string(i), 32});
  many.samples = std::vector<float>(65);
  EXPECT_THROW(read_file_image(write("many.exr", encode_file(many))), InputError);
}

}  // namespace
}  // namespace sweepkit::texmap
