// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "sweepkit/texmap/shrink.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace sweepkit::texmap {
namespace {

Image noise(int width, int height, int channels) {
  std::vector<std::uint16_t> texels(static_cast<std::size_t>(width * height * channels));
  std::uint32_t state = 1;
  for (std::uint16_t& texel : texels) {
    state = state * 1664525 + 1013904223;
    texel = static_cast<std::uint16_t>(state >> 16);
  }
  return {width, height, channels, texels};
}

std::uint16_t at(const Image& image, int x, int y, int c) {
  return std::get<std::vector<std::uint16_t>>(
      image.texels)[static_cast<std::size_t>((y * image.width + x) * image.channels + c)];
}

TEST(Shrink, FittingSizesKeepTheShapeAndAtLeastATexel) {
  EXPECT_EQ(fitting_size({1000, 500}, 1000), glm::ivec2(1000, 500));
  EXPECT_EQ(fitting_size({1000, 500}, 100), glm::ivec2(100, 50));
  EXPECT_EQ(fitting_size({8, 1024}, 64), glm::ivec2(1, 64));
  EXPECT_EQ(fitting_size({3, 4096}, 64), glm::ivec2(1, 64));
  EXPECT_EQ(fitting_size({1024, 768}, 3), glm::ivec2(3, 2));
}

TEST(Shrink, ASizeThatFitsChangesNothing) {
  const Image image = noise(7, 5, 3);
  EXPECT_EQ(shrink(image, {7, 5}).texels, image.texels);
}

// The mean of what a texel covers by another way: many points, each of the texel it falls in. Sides of 6 and
// 4 to 4 and 3: boundaries fall on whole twelfths, so that 12 x 12 points a texel of the image are exact.
TEST(Shrink, ATexelIsTheMeanOfWhatItCoversInPartsToo) {
  const Image image = noise(6, 4, 4);
  const Image small = shrink(image, {4, 3});
  ASSERT_EQ(small.width, 4);
  ASSERT_EQ(small.height, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      for (int c = 0; c < 4; ++c) {
        std::int64_t sum = 0;
        int count = 0;
        for (int py = y * 4 * 12 / 3; py < (y + 1) * 4 * 12 / 3; ++py) {
          for (int px = x * 6 * 12 / 4; px < (x + 1) * 6 * 12 / 4; ++px) {
            sum += at(image, px / 12, py / 12, c);
            ++count;
          }
        }
        EXPECT_EQ(at(small, x, y, c), (sum + count / 2) / count) << x << ", " << y;
      }
    }
  }
}

TEST(Shrink, ToOneTexelIsTheMeanOfAll) {
  const Image image = noise(13, 11, 1);
  std::int64_t sum = 0;
  for (const std::uint16_t texel : std::get<std::vector<std::uint16_t>>(image.texels)) sum += texel;
  EXPECT_EQ(at(shrink(image, {1, 1}), 0, 0, 0), (sum + 71) / 143);
}

TEST(Shrink, WhiteStaysWhiteAndFloatsKeepTheirRange) {
  const Image white{700, 900, 1, std::vector<std::uint16_t>(630000, 65535)};
  const Image small = shrink(white, {33, 41});
  for (int y = 0; y < 41; ++y) {
    for (int x = 0; x < 33; ++x) ASSERT_EQ(at(small, x, y, 0), 65535);
  }
  const Image sun{70, 90, 1, std::vector<float>(6300, 1e30f)};
  const Image dot = shrink(sun, {33, 41});
  for (const float texel : std::get<std::vector<float>>(dot.texels)) ASSERT_NEAR(texel / 1e30f, 1, 1e-6);
}

}  // namespace
}  // namespace sweepkit::texmap
