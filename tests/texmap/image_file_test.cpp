// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/image_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::texmap {
namespace {

class ImageFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("sweepkit_image_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::vector<std::byte>& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return folder_ / name;
  }
  std::string message(const std::filesystem::path& file) const {
    try {
      read_image(file, ColorSpace::kSrgb);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  std::filesystem::path folder_;
};

Image ramp() {
  Image image{64, 16, 3, std::vector<std::uint16_t>(64 * 16 * 3)};
  auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = static_cast<std::uint16_t>(i * 65535 / texels.size());
  return image;
}

TEST_F(ImageFile, EveryFormatIsReadBackAsItWasWritten) {
  const Image image = ramp();
  // 8 bits of sRGB are at most 1/255 * 2.3 / 2 off near white; JPEG adds its own loss; half has 11 bits.
  const std::vector<std::pair<const char*, double>> formats = {
      {"a.png", 0.005}, {"a.tif", 0.005}, {"a.jpg", 0.02}, {"a.exr", 0.0005}};
  for (const auto& [name, bound] : formats) {
    const std::filesystem::path file = write(name, encode_image(image, image_format(name)));
    EXPECT_LT(rmse(read_image(file, ColorSpace::kSrgb), image), bound) << name;
    const ImageFileInfo info = read_image_info(file);
    EXPECT_EQ(info.width, 64);
    EXPECT_EQ(info.height, 16);
    EXPECT_EQ(info.channels, 3);
  }
}

TEST_F(ImageFile, LinearDataSurvivesPngToTheBit) {
  Image image{256, 1, 1, std::vector<std::uint16_t>(256)};
  auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
  for (std::size_t i = 0; i < 256; ++i) texels[i] = static_cast<std::uint16_t>(257 * i);
  const std::filesystem::path file =
      write("data.png", encode_image(image, ImageFormat::kPng, ColorSpace::kLinear));
  EXPECT_EQ(std::get<0>(read_image(file, ColorSpace::kLinear).texels), texels);
}

TEST_F(ImageFile, EverySrgbByteSurvivesReadingAndWriting) {
  Image image{256, 1, 1, std::vector<std::uint16_t>(256)};
  auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
  for (std::size_t i = 0; i < 256; ++i) texels[i] = static_cast<std::uint16_t>(257 * i);
  const auto bytes = encode_image(image, ImageFormat::kPng, ColorSpace::kLinear);
  const Image decoded = read_image(write("a.png", bytes), ColorSpace::kSrgb);
  const auto again = encode_image(decoded, ImageFormat::kPng, ColorSpace::kSrgb);
  const Image back = read_image(write("b.png", again), ColorSpace::kLinear);
  EXPECT_EQ(std::get<0>(back.texels), texels);
}

TEST_F(ImageFile, TheSameImageGivesTheSameBytes) {
  for (const ImageFormat format :
       {ImageFormat::kPng, ImageFormat::kJpeg, ImageFormat::kTiff, ImageFormat::kExr}) {
    const auto first = encode_image(ramp(), format);
    sleep(format == ImageFormat::kTiff ? 1 : 0);  // a time stamp counts in seconds
    EXPECT_EQ(encode_image(ramp(), format), first);
  }
}

TEST_F(ImageFile, RefusesWhatIsNoImageByName) {
  EXPECT_EQ(message(folder_ / "none.png"), (folder_ / "none.png").string() + ": no such file");
  EXPECT_EQ(message(folder_), folder_.string() + ": is a folder, not an image");
  std::ofstream(folder_ / "text.png") << "This is no picture.\n";
  std::ofstream(folder_ / "empty.png").close();
  for (const char* name : {"text.png", "empty.png"}) {
    const std::string text = message(folder_ / name);
    EXPECT_EQ(text.find((folder_ / name).string() + ": cannot be read as an image: "), 0u) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
  }
}

TEST_F(ImageFile, RefusesATruncatedPngAtEveryLength) {
  const std::vector<std::byte> whole = encode_image(ramp(), ImageFormat::kPng);
  // The last chunk, 12 bytes, says only that the file ends; a picture without it is whole.
  for (std::size_t length = 0; length < whole.size() - 12; ++length) {
    const auto file = write("cut.png", {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
    EXPECT_EQ(message(file).find(file.string() + ": cannot be read as an image: "), 0u) << length;
  }
}

TEST_F(ImageFile, RefusesNanInAFloatImageWithItsPlace) {
  Image image = make_float_image(4, 4);
  std::get<std::vector<float>>(image.texels)[3 * 6 + 1] = std::nanf("");
  const auto file = write("nan.exr", encode_image(image, ImageFormat::kExr));
  EXPECT_EQ(message(file), file.string() + ": has NaN or infinity at pixel (2, 1); mend the image");
}

TEST(ImageFormat, ComesFromTheEndOfTheName) {
  EXPECT_EQ(image_format("a.PNG"), ImageFormat::kPng);
  EXPECT_EQ(image_format("a.b.jpeg"), ImageFormat::kJpeg);
  EXPECT_EQ(image_format("a.tiff"), ImageFormat::kTiff);
  EXPECT_THROW(image_format("a.gif"), InputError);
  EXPECT_THROW(image_format("png"), InputError);
}

}  // namespace
}  // namespace sweepkit::texmap
