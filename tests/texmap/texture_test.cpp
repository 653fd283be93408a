// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/texture.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace sweepkit::texmap {
namespace {

// 2 x 2 texels: 0 and 1 on top, 2 and 3 below (in steps of 1/65535).
Texture four_texels(Wrap wrap) {
  return ImageTexture{std::make_shared<const Image>(Image{2, 2, 1, std::vector<std::uint16_t>{0, 1, 2, 3}}),
                      wrap};
}

int texel(const Texture& texture, double u, double v) {
  return static_cast<int>(std::lround(65535 * point_sample(texture, {u, v}, {}).r));
}

TEST(PointSample, HasTheTopRowAtVOne) {
  EXPECT_EQ(texel(four_texels(Wrap::kRepeat), 0.25, 0.75), 0);
  EXPECT_EQ(texel(four_texels(Wrap::kRepeat), 0.75, 0.75), 1);
  EXPECT_EQ(texel(four_texels(Wrap::kRepeat), 0.25, 0.25), 2);
}

TEST(PointSample, RepeatsAndClampsFarOutside) {
  EXPECT_EQ(texel(four_texels(Wrap::kRepeat), -0.25, 0.25), 3);
  EXPECT_EQ(texel(four_texels(Wrap::kRepeat), 1e7 + 0.25, -1e7 + 0.75), 0);
  EXPECT_EQ(texel(four_texels(Wrap::kClamp), -5, 0.25), 2);
  EXPECT_EQ(texel(four_texels(Wrap::kClamp), 5, 1.0), 1);
  EXPECT_EQ(texel(four_texels(Wrap::kClamp), 1.0, 0.0), 3);
}

TEST(PointSample, MirrorsEveryOtherCopy) {
  EXPECT_EQ(texel(four_texels(Wrap::kMirror), 0.25, 0.75), 0);
  EXPECT_EQ(texel(four_texels(Wrap::kMirror), 1.25, 0.75), 1);
  EXPECT_EQ(texel(four_texels(Wrap::kMirror), -0.25, 0.75), 0);
  EXPECT_EQ(texel(four_texels(Wrap::kMirror), -1.25, 0.75), 1);
  EXPECT_EQ(texel(four_texels(Wrap::kMirror), 0.25, 1.25), 0);
  EXPECT_EQ(texel(four_texels(Wrap::kMirror), 0.25, 1.75), 2);
  EXPECT_EQ(texel(four_texels(Wrap::kMirror), 1e7 + 1.25, -1e7 + 0.75), 1);
}

TEST(PointSample, TakesNumbersThatAreNoneForTheFirstTexel) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClamp, Wrap::kMirror}) {
    EXPECT_EQ(texel(four_texels(wrap), nan, nan), 0);
    EXPECT_GE(texel(four_texels(wrap), infinity, -infinity), 0);
    EXPECT_GE(texel(four_texels(wrap), -1e308, 1e308), 0);
  }
}

}  // namespace
}  // namespace sweepkit::texmap
