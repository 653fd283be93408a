// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/image_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sweepkit/error.hpp"

namespace sweepkit::texmap {
namespace {

Image flat(float value, int size = 64) {
  Image image = make_float_image(size, size);
  for (float& v : std::get<std::vector<float>>(image.texels)) v = value;
  return image;
}

TEST(ImageError, RmseAndPsnrFollowTheirDefinitions) {
  EXPECT_NEAR(rmse(flat(0.5f), flat(0.25f)), 0.25, 1e-12);
  EXPECT_NEAR(psnr(flat(0.5f), flat(0.4f)), 20, 1e-5);  // 0.1 in float32
  EXPECT_TRUE(std::isinf(psnr(flat(0.5f), flat(0.5f))));
}

TEST(ImageError, LooksAtTheRectangleOrTheMaskAlone) {
  Image image = flat(0);
  std::get<std::vector<float>>(image.texels)[0] = 1;
  EXPECT_EQ(rmse(image, flat(0), PixelRect{1, 1, 5, 5}), 0);
  EXPECT_NEAR(rmse(image, flat(0), PixelRect{0, 0, 1, 1}), std::sqrt(1.0 / 3), 1e-12);
  std::vector<std::uint8_t> mask(64 * 64);
  EXPECT_EQ(rmse(image, flat(0), mask), 0);
  mask[0] = 1;
  EXPECT_NEAR(rmse(image, flat(0), mask), std::sqrt(1.0 / 3), 1e-12);
}

TEST(ImageError, RefusesPicturesOfDifferentSizes) {
  EXPECT_THROW(rmse(flat(0), flat(0, 32)), InputError);
  EXPECT_THROW(mean_flip(flat(0), flat(0, 32)), InputError);
  EXPECT_THROW(rmse(flat(0), flat(0), PixelRect{60, 0, 8, 8}), InputError);
}

TEST(Flip, IsZeroForEqualPicturesAndSymmetric) {
  EXPECT_EQ(mean_flip(flat(0.3f), flat(0.3f)), 0);
  EXPECT_NEAR(mean_flip(flat(0.3f), flat(0.6f)), mean_flip(flat(0.6f), flat(0.3f)), 1e-12);
}

TEST(Flip, OfBlackAndWhiteIsTheColourPipelinesFigure) {
  // Flat pictures have no features, so FLIP is the colour term alone: HyAB 100 to the power 0.7, past the
  // knee of 0.4 of that of green and blue (203.3 by the Hunt-adjusted Lab of both), mapped by the paper's two
  // lines.
  const double largest = std::pow(203.3, 0.7);
  const double knee = 0.4 * largest;
  const double expected = 0.95 + (std::pow(100, 0.7) - knee) / (largest - knee) * 0.05;
  EXPECT_NEAR(mean_flip(flat(0), flat(1)), expected, 1e-3);
}

TEST(Flip, GrowsWithTheDifference) {
  double before = 0;
  for (const float difference : {0.01f, 0.05f, 0.1f, 0.3f, 0.6f}) {
    const double flip = mean_flip(flat(0.2f), flat(0.2f + difference));
    EXPECT_GT(flip, before);
    before = flip;
  }
}

TEST(Flip, MindsAnEdgeMoreThanTheSameDifferenceWithoutOne) {
  Image edge = flat(0.4f);
  auto& texels = std::get<std::vector<float>>(edge.texels);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    if ((i / 3) % 64 >= 32) texels[i] = 0.5f;
  }
  // Half of the pixels differ by 0.1; without the feature term the mean were half of the flat picture's.
  EXPECT_GT(mean_flip(edge, flat(0.4f)), 0.5 * mean_flip(flat(0.5f), flat(0.4f)));
}

}  // namespace
}  // namespace sweepkit::texmap
