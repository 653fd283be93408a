// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "plane_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sweepkit::report {
namespace {

TEST(PlaneView, SeesAlongItsAxisWhatIsOneOverTheTangentAhead) {
  // The camera stands one unit high and looks 20 degrees down; the texture is two units wide.
  const double ahead = 0.5 / std::tan(20 * std::numbers::pi / 180);
  const glm::dvec2 straight = *PlaneView(64, 0).uv({32, 32});
  EXPECT_NEAR(straight.x, 0, 1e-15);
  EXPECT_NEAR(straight.y, ahead, 1e-14);
  const glm::dvec2 turned = *PlaneView(64, 90).uv({32, 32});
  EXPECT_NEAR(turned.x, -ahead, 1e-14);
  EXPECT_NEAR(turned.y, 0, 1e-14);
}

TEST(PlaneView, HasNoPlaceAboveTheHorizon) {
  EXPECT_FALSE(PlaneView(64, 0).uv({32, 0}));
}

TEST(PlaneView, LeavesOutWholeRowsAndNoOthers) {
  const PlaneView view(64, 35);
  const std::vector<PlanePixel> pixels = plane_pixels(view);
  const int first = pixels.front().y;
  EXPECT_GT(first, 0);
  ASSERT_EQ(pixels.size(), static_cast<std::size_t>(64 * (64 - first)));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_EQ(pixels[i].x, static_cast<int>(i % 64));
    EXPECT_EQ(pixels[i].y, first + static_cast<int>(i / 64));
  }
}

TEST(PlaneReference, OfOneGreyIsThatGrey) {
  const PlaneView view(16, 35);
  const PlaneTexture grey{32, std::vector<float>(32 * 32, 0.25f)};
  const PlaneReference reference = plane_reference(view, grey, plane_pixels(view));
  for (const double value : reference.tent) EXPECT_NEAR(value, 0.25, 1e-13);
  for (const double value : reference.box) EXPECT_NEAR(value, 0.25, 1e-13);
  EXPECT_LT(reference.tent_error, 1e-13);
  EXPECT_LT(reference.box_error, 1e-13);
}

// The mean of n x n samples under a tent or a box, sixteen times as many as the reference takes.
double denser(const PlaneView& view, const PlaneTexture& texture, const PlanePixel& pixel, double reach) {
  constexpr int kSamples = 256;
  double sum = 0;
  double weights = 0;
  for (int j = 0; j < kSamples; ++j) {
    for (int i = 0; i < kSamples; ++i) {
      const glm::dvec2 offset = reach * (glm::dvec2(2 * i + 1, 2 * j + 1) / double{kSamples} - 1.0);
      const glm::dvec2 uv = *view.uv(glm::dvec2(pixel.x + 0.5, pixel.y + 0.5) + offset);
      const glm::dvec2 inside = glm::fract(glm::dvec2(uv.x, 1 - uv.y)) * double(texture.side);
      const double weight = reach < 1 ? 1 : (1 - std::abs(offset.x)) * (1 - std::abs(offset.y));
      sum += weight *
             static_cast<double>(
                 texture.texels[static_cast<std::size_t>(inside.y) * static_cast<std::size_t>(texture.side) +
                                static_cast<std::size_t>(inside.x)]);
      weights += weight;
    }
  }
  return sum / weights;
}

TEST(PlaneReference, IsAsNearToAFarDenserOneAsItSays) {
  const PlaneView view(32, 35);
  const PlaneTexture texture = checker_texture(64);
  const std::vector<PlanePixel> pixels = plane_pixels(view);
  const PlaneReference reference = plane_reference(view, texture, pixels);
  double tent = 0;
  double box = 0;
  int count = 0;
  for (std::size_t i = 0; i < pixels.size(); i += 11) {
    tent += std::pow(reference.tent[i] - denser(view, texture, pixels[i], 1), 2);
    box += std::pow(reference.box[i] - denser(view, texture, pixels[i], 0.5), 2);
    ++count;
  }
  // An estimate of the error, by a part of the pixels: within a factor of 2.
  EXPECT_LE(std::sqrt(tent / count), 2 * reference.tent_error);
  EXPECT_LE(std::sqrt(box / count), 2 * reference.box_error);
  // Far less than the best of the filters is off by, which is 7e-3 of 1.
  EXPECT_LT(reference.tent_error, 1e-3);
  EXPECT_LT(reference.box_error, 2e-3);
}

}  // namespace
}  // namespace sweepkit::report
