// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/image_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "png.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_error.hpp"
#include "tiff.hpp"

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

TEST_F(ImageFile, EveryChannelCountIsReadBackTexelForTexel) {
  // Colours where alpha is small or 0 are kept as they are, neither multiplied by it nor divided.
  for (const int channels : {1, 2, 3, 4}) {
    Image image{5, 3, channels, std::vector<std::uint16_t>(static_cast<std::size_t>(15 * channels))};
    auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
    for (std::size_t i = 0; i < texels.size(); ++i)
      texels[i] = static_cast<std::uint16_t>(257 * ((37 * i + 11) % 256));
    texels.back() = 0;
    for (const char* name : {"a.png", "a.tif"}) {
      const Image back = read_image(write(name, encode_image(image, image_format(name), ColorSpace::kLinear)),
                                    ColorSpace::kLinear);
      EXPECT_EQ(back.channels, channels) << name;
      EXPECT_EQ(std::get<0>(back.texels), texels) << name << " " << channels;
    }
    // JPEG has no alpha; it is left out.
    EXPECT_EQ(read_image(write("a.jpg", encode_image(image, ImageFormat::kJpeg)), ColorSpace::kSrgb).channels,
              channels <= 2 ? 1 : 3);
  }
}

TEST_F(ImageFile, SixteenBitsAreReadToTheLastOne) {
  std::vector<std::uint8_t> rows;
  std::vector<std::uint16_t> want;
  for (int i = 0; i < 3 * 16 * 4; ++i) {
    want.push_back(static_cast<std::uint16_t>(i * 341 + 5));
    rows.push_back(static_cast<std::uint8_t>(want.back() >> 8));
    rows.push_back(static_cast<std::uint8_t>(want.back() & 255));
  }
  const auto file = write("deep.png", make_png({16, 4, 16, 2}, rows));
  EXPECT_EQ(std::get<0>(read_image(file, ColorSpace::kLinear).texels), want);
  EXPECT_EQ(read_image_info(file).sample_type, "uint16");
  // sRGB by the curve, rounded to nearest.
  const Image decoded = read_image(file, ColorSpace::kSrgb);
  for (std::size_t i = 0; i < want.size(); ++i) {
    const double x = want[i] / 65535.0;
    const double linear = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(std::get<0>(decoded.texels)[i], 65535 * linear, 0.5 + 1e-9);
  }
}

TEST_F(ImageFile, PalettesAndSingleBitsAreReadAsColours) {
  const std::vector<std::uint8_t> palette = {255, 0, 0, 0, 0, 255};
  const Image colors =
      read_image(write("palette.png", make_png({2, 1, 8, 3}, std::vector<std::uint8_t>{1, 0}, palette)),
                 ColorSpace::kSrgb);
  EXPECT_EQ(colors.color(0, 0), glm::vec3(0, 0, 1));
  EXPECT_EQ(colors.color(1, 0), glm::vec3(1, 0, 0));
  const Image bits = read_image(
      write("bits.png", make_png({8, 1, 1, 0}, std::vector<std::uint8_t>{0b10100000})), ColorSpace::kSrgb);
  EXPECT_EQ(bits.color(0, 0), glm::vec3(1));
  EXPECT_EQ(bits.color(1, 0), glm::vec3(0));
  EXPECT_EQ(bits.color(2, 0), glm::vec3(1));
}

TEST_F(ImageFile, FloatsSurviveExrUpToTheEndOfHalf) {
  Image image = make_float_image(2, 2);
  auto& texels = std::get<std::vector<float>>(image.texels);
  texels = {0, 1, 0.5f, 100, -2, 1024, 0.25f, 3, 60000, 65504, 1e9f, HUGE_VALF};
  const Image back = read_image(write("a.exr", encode_image(image, ImageFormat::kExr)), ColorSpace::kLinear);
  texels[8] = 60000;  // a half, as are the others
  texels[10] = texels[11] = 65504;
  EXPECT_EQ(std::get<1>(back.texels), texels);
}

TEST_F(ImageFile, ValuesOutsideZeroToOneAreClampedInEightBits) {
  Image image = make_float_image(2, 1);
  std::get<std::vector<float>>(image.texels) = {-1, 0, 2, HUGE_VALF, 1, std::nanf("")};
  const Image back = read_image(write("a.png", encode_image(image, ImageFormat::kPng)), ColorSpace::kSrgb);
  EXPECT_EQ(std::get<0>(back.texels), (std::vector<std::uint16_t>{0, 0, 65535, 65535, 65535, 0}));
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

TEST_F(ImageFile, RefusesEveryOtherFormatCutShort) {
  // JPEG without its last two bytes, the mark of its end, counts as cut too: no decoder can tell the two
  // apart.
  for (const char* name : {"cut.jpg", "cut.tif", "cut.exr"}) {
    const std::vector<std::byte> whole = encode_image(ramp(), image_format(name));
    std::size_t length = 0;
    while (length < whole.size()) {
      const auto file = write(name, {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
      EXPECT_EQ(message(file).find(file.string() + ": cannot be read as an image: "), 0u)
          << name << " " << length << ": " << message(file);
      length += whole.size() - length > 16 ? 9 : 1;
    }
  }
}

TEST_F(ImageFile, RefusesSizesThatNoImageHas) {
  const std::vector<std::uint8_t> a_row(3);
  for (const PngHeader& header :
       {PngHeader{0, 1}, PngHeader{1, 0}, PngHeader{0, 0}, PngHeader{2000000000, 2000000000},
        PngHeader{60000, 50000}, PngHeader{40000, 30000}}) {
    // The last would need 7 GB: it must fail on the rows that are missing, not on the memory.
    const auto file = write("size.png", make_png(header, a_row));
    EXPECT_EQ(message(file).find(file.string() + ": cannot be read as an image: "), 0u) << message(file);
  }
}

TEST_F(ImageFile, RefusesAPictureThatIsNone) {
  EXPECT_THROW(encode_image(Image{0, 0, 3, std::vector<float>{}}, ImageFormat::kPng), OutputError);
}

TEST_F(ImageFile, RefusesNanInAFloatImageWithItsPlace) {
  // By hand: sweepkit's own writer writes none.
  std::vector<float> samples(4 * 4);
  samples[6] = std::nanf("");
  const auto file = write("nan.tif", make_tiff({.width = 4, .height = 4, .bits = 32, .is_float = true},
                                               std::as_bytes(std::span(samples))));
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
