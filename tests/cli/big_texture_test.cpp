// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Textures larger than the memory that they may have: the picture is the same as with all the memory there
// is.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

// A pattern with detail of every size that still packs well.
std::uint8_t texel(int x, int y, int channel) {
  const int coarse = ((x >> 9) * 7 + (y >> 9) * 13 + channel * 5) % 16;
  return static_cast<std::uint8_t>(8 * coarse + (((x >> 4) ^ (y >> 3)) & 63) + ((x & y & 1) != 0 ? 40 : 0));
}

// A square image file, tiled if `tile` is not 0; the kind is in the name's ending.
void write_image(const std::filesystem::path& file, int size, int tile) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(file.string());
  OIIO::ImageSpec spec(size, size, 3, OIIO::TypeDesc::UINT8);
  spec.tile_width = spec.tile_height = tile;
  spec.attribute("compression", "zip");
  spec.attribute("zipquality", 1);
  spec.attribute("png:compressionLevel", 1);
  if (!output || !output->open(file.string(), spec)) throw std::runtime_error(OIIO::geterror());
  const int rows = tile > 0 ? tile : 64;
  std::vector<std::uint8_t> band(static_cast<std::size_t>(3) * static_cast<std::size_t>(size) *
                                 static_cast<std::size_t>(rows));
  for (int y = 0; y < size; y += rows) {
    auto to = band.begin();
    for (int row = y; row < y + rows; ++row) {
      for (int x = 0; x < size; ++x) {
        for (int k = 0; k < 3; ++k) *to++ = texel(x, row, k);
      }
    }
    const bool is_written =
        tile > 0 ? output->write_tiles(0, size, y, y + rows, 0, 1, OIIO::TypeDesc::UINT8, band.data())
                 : output->write_scanlines(y, y + rows, 0, OIIO::TypeDesc::UINT8, band.data());
    if (!is_written) throw std::runtime_error(output->geterror());
  }
  output->close();
}

// A floor from under the camera to the horizon, askew to the texture: texels larger than pixels in front,
// thousands of them to a pixel far off.
std::string floor_with(const std::string& image) {
  return R"({"sweepkit": 1, "ambient": [1, 1, 1],
  "camera": {"eye": [3, 0.4, 5], "target": [0, 0, 0], "fov_deg": 60, "width": 512, "height": 512},
  "textures": {"t": {"image": ")" +
         image + R"("}}, "materials": {"m": {"diffuse": [1, 1, 1], "texture": "t"}},
  "objects": [{"name": "floor", "material": "m", "rotate_deg": [0, 20, 0], "plane": {"size": [80, 80]},
               "uv": {"repeat": [4, 4]}}]})";
}

struct Drawn {
  std::string picture;
  std::size_t peak_bytes = 0;
};
Drawn draw(const Workshop& workshop, const std::string& filter, int megabytes) {
  const Outcome run = workshop.sweepkit(
      {"render", "s.json", "-o", "p.png", "--filter", filter, "--texture-memory", std::to_string(megabytes)});
  EXPECT_EQ(run.status, 0) << run.err;
  return {workshop.read("p.png"), run.peak_bytes};
}

// What the program, OpenImageIO and its 261 libraries take besides textures.
constexpr std::size_t kMegabyte = std::size_t{1} << 20;
constexpr std::size_t kBesides = 200 * kMegabyte;

void expect_the_same_within(const Workshop& workshop, const std::string& filter, int megabytes, int plenty) {
  SCOPED_TRACE(filter);
  const Drawn bounded = draw(workshop, filter, megabytes);
  const Drawn unbounded = draw(workshop, filter, plenty);
  EXPECT_TRUE(bounded.picture == unbounded.picture);
  EXPECT_LT(bounded.peak_bytes, static_cast<std::size_t>(megabytes) * kMegabyte + kBesides);
  testing::Test::RecordProperty("peak_megabytes_" + filter, static_cast<int>(bounded.peak_bytes / kMegabyte));
  testing::Test::RecordProperty("peak_megabytes_with_plenty_" + filter,
                                static_cast<int>(unbounded.peak_bytes / kMegabyte));
}

TEST(BigTexture, OfEveryKindOfFileGivesTheSamePictureInAFewMegabytes) {
  const Workshop workshop;
  for (const auto& [name, tile] : {std::pair{"t.png", 0}, std::pair{"t.tif", 64}, std::pair{"t.exr", 0}}) {
    SCOPED_TRACE(name);
    write_image(workshop.folder() / name, 2048, tile);
    workshop.write("s.json", floor_with(name));
    expect_the_same_within(workshop, "auto", 16, 8192);
  }
}

// auto reads what bilinear and ewa do.
constexpr const char* kOtherFilters[] = {"trilinear", "integral-1", "integral-2", "integral-3"};

TEST(BigTexture, GivesTheSamePictureInAFewMegabytesByEveryFilter) {
  const Workshop workshop;
  write_image(workshop.folder() / "t.tif", 2048, 64);
  workshop.write("s.json", floor_with("t.tif"));
  for (const char* filter : kOtherFilters) expect_the_same_within(workshop, filter, 16, 8192);
}

TEST(BigTexture, TakesTheWholeMemoryOfNoneButLeavesNothingBehind) {
  const Workshop workshop;
  write_image(workshop.folder() / "t.png", 2048, 0);
  workshop.write("s.json", floor_with("t.png"));
  std::filesystem::create_directory(workshop.folder() / "tmp");
  const Outcome run =
      workshop.shell("TMPDIR=tmp sweepkit render s.json -o p.png --texture-memory 16 && ls tmp");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(BigTexture, SaysWhereItCannotUnpack) {
  const Workshop workshop;
  write_image(workshop.folder() / "t.png", 2048, 0);
  workshop.write("s.json", floor_with("t.png"));
  // A file may not grow past a megabyte: a disk that is full.
  const Outcome run = workshop.shell("ulimit -f 1024; sweepkit render s.json -o p.png --texture-memory 16");
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("cannot unpack"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("TMPDIR"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(workshop.folder() / "p.png"));
}

TEST(BigTexture, ThatIsCutShortIsRefusedWhenTheGapIsMet) {
  const Workshop workshop;
  write_image(workshop.folder() / "t.tif", 2048, 64);
  std::filesystem::resize_file(workshop.folder() / "t.tif",
                               std::filesystem::file_size(workshop.folder() / "t.tif") / 2);
  workshop.write("s.json", floor_with("t.tif"));
  const Outcome run = workshop.sweepkit({"render", "s.json", "-o", "p.png", "--texture-memory", "16"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("t.tif"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(workshop.folder() / "p.png"));
}

TEST(BigTextureLong, Of8192GivesTheSamePictureIn64Megabytes) {
  const Workshop workshop;
  for (const auto& [name, tile] : {std::pair{"t.png", 0}, std::pair{"t.tif", 64}}) {
    SCOPED_TRACE(name);
    write_image(workshop.folder() / name, 8192, tile);
    workshop.write("s.json", floor_with(name));
    expect_the_same_within(workshop, "auto", 64, 16384);
  }
}

TEST(BigTextureLong, Of8192GivesTheSamePictureIn64MegabytesByEveryFilter) {
  const Workshop workshop;
  write_image(workshop.folder() / "t.tif", 8192, 64);
  workshop.write("s.json", floor_with("t.tif"));
  for (const char* filter : kOtherFilters) expect_the_same_within(workshop, filter, 64, 16384);
}

TEST(BigTextureLong, Of32768GivesTheSamePictureIn512Megabytes) {
  const Workshop workshop;
  write_image(workshop.folder() / "t.tif", 32768, 128);
  workshop.write("s.json", floor_with("t.tif"));
  for (const char* filter : {"auto", "integral-2"}) expect_the_same_within(workshop, filter, 512, 2048);
}

}  // namespace
}  // namespace sweepkit::test
