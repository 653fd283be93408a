// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// A million random boxes for each order, over textures of every shape up to 4,096 texels.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "integral_texture.hpp"
#include "random_image.hpp"
#include "spline_reference.hpp"

namespace sweepkit::texmap {
namespace {

using reference::Box;
using reference::Whole;
using test::IntegralTexture;
using test::random_image;

constexpr Wrap kWraps[] = {Wrap::kRepeat, Wrap::kClamp, Wrap::kMirror};
constexpr std::pair<int, int> kSizes[] = {{4096, 4096}, {2048, 512}, {4096, 1}, {1, 4095}, {3001, 17},
                                          {257, 4093},  {640, 480},  {64, 64},  {63, 65},  {5, 3}};
constexpr int kBoxes = 1000000 / (2 * 3 * static_cast<int>(std::size(kSizes))) + 1;
constexpr double kLevel = 1.0 / 255;

class IntegralBoxes : public testing::TestWithParam<int> {
 protected:
  int order() const { return GetParam(); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  // Few of them, but of every order, weigh the texels themselves. One in fifty is wide along one axis: the
  // reference looks at every texel.
  std::pair<double, double> sides() {
    const double most = 7 - order();
    const double small = std::exp2(real(0, most));
    const double other = std::exp2(real(0, wide_++ % 50 == 0 ? 8 : most));
    return wide_ % 2 == 0 ? std::pair{small, other} : std::pair{other, small};
  }
  // Near the image, near its border, or up to a hundred images away.
  double place(int size) {
    const double far = random_() % 8 == 0 ? 100 : 1;
    return random_() % 3 == 0 ? far * size + real(-20, 20) : real(-far * size, 2 * far * size);
  }

  std::mt19937 random_{1};
  int wide_ = 0;
};
INSTANTIATE_TEST_SUITE_P(Order, IntegralBoxes, testing::Values(1, 2, 3));

// An 8-bit file's texels are multiples of 257.
Image image_of(int width, int height, bool has_8_bits) {
  Image image = random_image(width, height, 1);
  if (has_8_bits) {
    for (std::uint16_t& texel : std::get<std::vector<std::uint16_t>>(image.texels))
      texel = static_cast<std::uint16_t>(257 * (texel >> 8));
  }
  return image;
}

bool is_power_of_two(int size) {
  return (size & (size - 1)) == 0;
}

TEST_P(IntegralBoxes, AreExactWithIntegerCornersAndWithinAThousandthOfALevelElse) {
  int count = 0;
  double worst = 0;
  for (const auto& [width, height] : kSizes) {
    // One copy for the three wraps.
    const auto image = std::make_shared<const Image>(image_of(width, height, height % 2 == 1));
    // (u,v) name the corner of a box as well as a double can: other sizes miss whole ones by 1e-12 of a
    // texel.
    const double place_error = is_power_of_two(width) && is_power_of_two(height) ? 0 : 1e-11;
    for (const Wrap wrap : kWraps) {
      IntegralTexture texture(image, wrap, order());
      for (int n = 0; n < kBoxes; ++n, count += 2) {
        const auto [w, h] = sides();
        const Box box{place(width), place(height), w, h};
        const int k = n % 3;
        const double want = reference::value<long double>(*image, wrap, box, order(), k);
        const double error = std::abs(texture.over(box)[k] - want);
        worst = std::max(worst, error);
        ASSERT_LE(error, 1e-3 * kLevel) << box.x << ' ' << box.y << ' ' << w << ' ' << h;

        const Box whole{std::floor(box.x), std::floor(box.y), std::floor(w), std::floor(h)};
        const double exact = reference::value<Whole>(*image, wrap, whole, order(), k);
        // The float that is nearest to the exact value, no other.
        ASSERT_LE(std::abs(texture.over(whole)[k] - exact), reference::half_step(exact) + place_error)
            << whole.x << ' ' << whole.y << ' ' << whole.width << ' ' << whole.height;
      }
    }
  }
  RecordProperty("boxes", count);
  RecordProperty("largest_error_in_levels", std::to_string(worst / kLevel));
}

TEST_P(IntegralBoxes, OfFloatTexturesAreWithinAHundredthOfALevel) {
  Image image = random_image(4096, 4096, 2, true);
  // HDR: relative to the range.
  constexpr float kRange = 60000;
  for (float& texel : std::get<std::vector<float>>(image.texels)) texel = kRange * texel - 10;
  IntegralTexture texture(std::move(image), Wrap::kRepeat, order());
  double worst = 0;
  for (int n = 0; n < 100000; ++n) {
    // Narrow along one axis at least, where a table that is not exact is at its worst.
    const bool is_tall = n % 2 == 0;
    const double narrow = real(1, 2);
    const double wide = n % 4 < 2 ? real(1, 3) : real(80, 120);
    const Box box{real(0, 4096), real(3000, 4096), is_tall ? narrow : wide, is_tall ? wide : narrow};
    const double want = reference::value<long double>(texture.image(), Wrap::kRepeat, box, order(), n % 3);
    worst = std::max(worst, std::abs(texture.over(box)[n % 3] - want) / kRange);
    ASSERT_LE(worst, 0.01 * kLevel) << box.x << ' ' << box.y << ' ' << box.width << ' ' << box.height;
  }
  RecordProperty("largest_error_in_levels", std::to_string(worst / kLevel));
}

}  // namespace
}  // namespace sweepkit::texmap
