// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// What another program finds in the files: channels and their names, windows, alpha, exposure.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

using Arguments = std::vector<std::string>;

// A card of one colour before a background of another, of 40 x 30 pixels.
const char* const kCard = R"({"sweepkit": 1,
  "camera": {"eye": [0, 3, 0], "target": [0, 0, 0], "up": [0, 0, -1], "width": 40, "height": 30},
  "background": [0.5, 0.25, 0.125], "ambient": [1, 1, 1], "materials": {"m": {"diffuse": [0.25, 0.5, 0.75]}},
  "objects": [{"name": "card", "material": "m", "plane": {"size": [1.06, 1.06]}}]})";

struct Picture {
  OIIO::ImageSpec spec;
  std::vector<float> samples;

  float at(int x, int y, const std::string& channel) const {
    const int k = spec.channelindex(channel);
    if (k < 0) throw std::runtime_error("no channel " + channel);
    const auto pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(spec.width) + static_cast<std::size_t>(x);
    return samples[pixel * static_cast<std::size_t>(spec.nchannels) + static_cast<std::size_t>(k)];
  }
};

class PictureFile : public testing::Test {
 protected:
  void SetUp() override { workshop_.write("scene.json", kCard); }

  void draw(const std::string& file, const Arguments& more = {}) const {
    Arguments arguments = {"render", "scene.json", "-o", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = workshop_.sweepkit(arguments);
    ASSERT_EQ(run.status, 0) << run.err;
  }
  // Its own numbers: colours as the file has them, not multiplied by alpha on the way.
  Picture read(const std::string& file) const {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open((workshop_.folder() / file).string(), &config);
    if (!input) throw std::runtime_error(file + ": " + OIIO::geterror());
    Picture picture{input->spec(), {}};
    picture.samples.resize(picture.spec.image_pixels() * static_cast<std::size_t>(picture.spec.nchannels));
    input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, picture.samples.data());
    return picture;
  }

  Workshop workshop_;
};

double srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

TEST_F(PictureFile, IsSrgbInIntegersAndLinearInFloats) {
  const double card[3] = {0.25, 0.5, 0.75};
  const char* const names[3] = {"R", "G", "B"};
  struct Case {
    const char* file;
    const char* bits;
    double half_level;
  };
  // Half a level of each depth; JPEG keeps a flat colour to a level or two.
  for (const Case& c : {Case{"a.png", "8", 0.5 / 255},
                        {"b.png", "16", 0.5 / 65535},
                        {"a.tif", "8", 0.5 / 255},
                        {"b.tif", "16", 0.5 / 65535},
                        {"a.jpg", "8", 2.5 / 255}}) {
    draw(c.file, {"--bits", c.bits});
    const Picture picture = read(c.file);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(picture.at(20, 15, names[k]), srgb(card[k]), c.half_level + 1e-7) << c.file;
  }
  for (const char* bits : {"16", "32"}) {
    draw("a.exr", {"--bits", bits});
    const Picture picture = read("a.exr");
    EXPECT_EQ(picture.spec.format, std::string(bits) == "16" ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(picture.at(20, 15, names[k]), static_cast<float>(card[k]));
  }
}

TEST_F(PictureFile, IsExposedByStops) {
  draw("a.exr", {"--bits", "32", "--exposure", "-3"});
  EXPECT_EQ(read("a.exr").at(20, 15, "G"), 0.0625f);
  draw("a.exr", {"--bits", "32", "--exposure", "0.5"});
  EXPECT_FLOAT_EQ(read("a.exr").at(20, 15, "G"), std::sqrt(0.5f));
  draw("a.png", {"--exposure", "1", "--bits", "16"});
  EXPECT_EQ(read("a.png").at(20, 15, "G"), 1);
  EXPECT_NEAR(read("a.png").at(20, 15, "R"), srgb(0.5), 0.5 / 65535 + 1e-7);
  EXPECT_EQ(read("a.png").at(20, 15, "B"), 1) << "clamped";
}

TEST_F(PictureFile, HasColoursMultipliedByAlphaInExrAndPlainElsewhere) {
  const Arguments options = {"--alpha", "--antialias", "3x3"};
  draw("a.exr", {"--alpha", "--antialias", "3x3", "--bits", "32"});
  draw("a.png", options);
  draw("a.tif", options);
  const Picture exr = read("a.exr");
  EXPECT_EQ(exr.at(0, 0, "A"), 0);
  EXPECT_EQ(exr.at(0, 0, "R"), 0);
  EXPECT_EQ(exr.at(20, 15, "A"), 1);
  int rim = 0;
  for (int x = 0; x < 40; ++x) {
    const float alpha = exr.at(x, 15, "A");
    EXPECT_FLOAT_EQ(exr.at(x, 15, "R"), 0.25f * alpha);
    EXPECT_FLOAT_EQ(exr.at(x, 15, "B"), 0.75f * alpha);
    if (alpha > 0 && alpha < 1) ++rim;
    for (const char* file : {"a.png", "a.tif"}) {
      const Picture plain = read(file);
      EXPECT_NEAR(plain.at(x, 15, "A"), alpha, 0.5 / 255 + 1e-7);
      EXPECT_NEAR(plain.at(x, 15, "R"), alpha > 0 ? srgb(0.25) : 0, 0.5 / 255 + 1e-7) << file << " " << x;
    }
  }
  EXPECT_GT(rim, 0) << "the card's rim cuts pixels";
}

TEST_F(PictureFile, HasLayersByNamesThatOtherProgramsKnow) {
  draw("a.exr", {"--aov", "depth,normal,uv,object-id,footprint,rays", "--alpha"});
  const Picture picture = read("a.exr");
  for (const char* channel : {"R", "G", "B", "A"}) {
    EXPECT_EQ(picture.spec.channelformat(picture.spec.channelindex(channel)), OIIO::TypeDesc::HALF);
  }
  for (const char* channel : {"depth.Z", "normal.X", "normal.Y", "normal.Z", "uv.U", "uv.V", "object_id.X",
                              "footprint.X", "footprint.Y", "rays.X"}) {
    ASSERT_GE(picture.spec.channelindex(channel), 0) << channel;
    EXPECT_EQ(picture.spec.channelformat(picture.spec.channelindex(channel)), OIIO::TypeDesc::FLOAT);
  }
  EXPECT_EQ(picture.spec.nchannels, 14);
  EXPECT_NEAR(picture.at(20, 15, "depth.Z"), 3, 4e-7);
  EXPECT_EQ(picture.at(20, 15, "normal.Y"), 1);
  EXPECT_EQ(picture.at(20, 15, "object_id.X"), 1);
  EXPECT_EQ(picture.at(0, 0, "object_id.X"), 0);
  EXPECT_EQ(picture.at(0, 0, "rays.X"), 1);
}

TEST_F(PictureFile, HasItsLayersInFilesBesideWhereItCannotHoldThem) {
  draw("a.png", {"--aov", "normal,depth"});
  const Picture normal = read("a.normal.exr");
  EXPECT_EQ(normal.spec.channelnames, (std::vector<std::string>{"normal.X", "normal.Y", "normal.Z"}));
  EXPECT_EQ(normal.spec.format, OIIO::TypeDesc::FLOAT);
  EXPECT_EQ(normal.at(20, 15, "normal.Y"), 1);
  draw("a.exr", {"--aov", "normal,depth"});
  EXPECT_EQ(read("a.exr").at(3, 20, "depth.Z"), read("a.depth.exr").at(3, 20, "depth.Z"));
}

TEST_F(PictureFile, OfACropKnowsItsPlaceInAnExr) {
  draw("whole.exr");
  draw("part.exr", {"--crop", "10,5,20,15"});
  const Picture whole = read("whole.exr");
  const Picture part = read("part.exr");
  EXPECT_EQ(part.spec.x, 10);
  EXPECT_EQ(part.spec.y, 5);
  EXPECT_EQ(part.spec.full_width, 40);
  EXPECT_EQ(part.spec.full_height, 30);
  ASSERT_EQ(part.spec.width, 20);
  ASSERT_EQ(part.spec.height, 15);
  for (int y = 0; y < 15; ++y) {
    for (int x = 0; x < 20; ++x) EXPECT_EQ(part.at(x, y, "G"), whole.at(10 + x, 5 + y, "G"));
  }
  draw("part.png", {"--crop", "10,5,20,15"});
  EXPECT_EQ(read("part.png").spec.width, 20);
}

TEST_F(PictureFile, HasNoMarkWhereNobodyAsksForOne) {
  draw("a.png");
  EXPECT_EQ(read("a.png").spec.get_string_attribute("ImageDescription"), "");
  draw("a.png", {"--tile", "2/3"});
  const std::string mark(read("a.png").spec.get_string_attribute("ImageDescription"));
  EXPECT_EQ(mark.find("sweepkit-picture key="), 0u) << mark;
  EXPECT_NE(mark.find(" size=40x30 area=0,0,40,30 tile=2/3 whole=plain"), std::string::npos) << mark;
}

TEST_F(PictureFile, OfLightBeyondHalfsHasNeitherNanNorInfinity) {
  draw("a.exr", {"--exposure", "64", "--set", "/background=[65504, 0, 1]"});
  for (const float value : read("a.exr").samples) EXPECT_TRUE(std::isfinite(value));
}

// Light beyond 1 keeps its size from one file to the other.
TEST_F(PictureFile, OfAFloatBackgroundHasItsLightBeyondOne) {
  std::vector<float> sky;
  for (int i = 0; i < 16 * 8; ++i) sky.insert(sky.end(), {0.25f, 1, 40});
  const auto output = OIIO::ImageOutput::create((workshop_.folder() / "sky.exr").string());
  ASSERT_TRUE(output != nullptr);
  ASSERT_TRUE(output->open((workshop_.folder() / "sky.exr").string(), {16, 8, 3, OIIO::TypeDesc::FLOAT}));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, sky.data()));
  output->close();
  std::string scene = kCard;
  const std::string plain = "[0.5, 0.25, 0.125]";
  scene.replace(scene.find(plain), plain.size(), R"({"image": "sky.exr"})");
  workshop_.write("scene.json", scene);
  draw("a.exr", {"--bits", "32"});
  const Picture picture = read("a.exr");
  // In the corner no card is seen. Float tiles are sums of texels in float32: a few roundings of each
  // channel.
  EXPECT_NEAR(picture.at(0, 0, "R"), 0.25, 0.25 * 1e-6);
  EXPECT_NEAR(picture.at(0, 0, "G"), 1, 1e-6);
  EXPECT_NEAR(picture.at(0, 0, "B"), 40, 40 * 1e-6);
  EXPECT_NEAR(picture.at(20, 15, "G"), 0.5, 1e-6);
  const Outcome info = workshop_.sweepkit({"info", "scene.json"});
  EXPECT_EQ(info.status, 0) << info.err;
  EXPECT_NE(info.out.find("background"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("sky.exr"), std::string::npos) << info.out;
}

}  // namespace
}  // namespace sweepkit::test
