// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// The filters integral-1, -2 and -3 against sums over every texel.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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
// A level of 8 bits; promises are told in it.
constexpr double kLevel = 1.0 / 255;

class RepeatedIntegration : public testing::TestWithParam<int> {
 protected:
  int order() const { return GetParam(); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  std::mt19937 random_{1};
};
INSTANTIATE_TEST_SUITE_P(Order, RepeatedIntegration, testing::Values(1, 2, 3));

TEST_P(RepeatedIntegration, IsExactForIntegerCorners) {
  // Powers of two: (u,v) name the corners exactly. Less and more than a tile's side.
  for (const auto& [width, height] : {std::pair{8, 4}, std::pair{1, 16}, std::pair{128, 256}}) {
    for (const Wrap wrap : kWraps) {
      IntegralTexture texture(random_image(width, height, 2), wrap, order());
      for (int n = 0; n < 500; ++n) {
        const Box box{whole(-3 * width, 3 * width), whole(-3 * height, 3 * height), whole(1, 20),
                      whole(1, 20)};
        const glm::vec3 color = texture.over(box);
        for (int k = 0; k < 3; ++k) {
          const double want = reference::value<Whole>(texture.image(), wrap, box, order(), k);
          // No float is nearer.
          EXPECT_LE(std::abs(color[k] - want), reference::half_step(want))
              << box.x << ' ' << box.y << ' ' << box.width << ' ' << box.height;
        }
      }
    }
  }
}

TEST_P(RepeatedIntegration, AgreesWithASumOverTheTexelsOnBoxesInAnyPlace) {
  for (const bool is_float : {false, true}) {
    for (const auto& [width, height] :
         {std::pair{7, 5}, std::pair{1, 1}, std::pair{64, 65}, std::pair{200, 100}}) {
      for (const Wrap wrap : kWraps) {
        IntegralTexture texture(random_image(width, height, 4, is_float), wrap, order());
        for (int n = 0; n < 100; ++n) {
          // From a texel, where nothing is widened yet, to far more than the texture.
          const Box box{real(-3 * width, 3 * width), real(-3 * height, 3 * height), std::exp2(real(0, 6)),
                        std::exp2(real(0, 6))};
          const glm::vec3 color = texture.over(box);
          for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(color[k], reference::value<long double>(texture.image(), wrap, box, order(), k),
                        1e-4 * kLevel)
                << box.x << ' ' << box.y << ' ' << box.width << ' ' << box.height;
          }
        }
      }
    }
  }
}

TEST_P(RepeatedIntegration, LosesNothingAtTheFarCornerOfALargeTable) {
  // A texel or two where the sums are largest: a table in float32 is hundreds of levels off there at order 1,
  // one in double nine levels at order 2. Narrow in y, so that the table is read and not the texels.
  for (const bool is_float : {false, true}) {
    IntegralTexture texture(random_image(2048, 1024, 10, is_float), Wrap::kClamp, order());
    for (int n = 0; n < 100; ++n) {
      const Box box{2048 - real(2, 200), 1024 - real(2, 40), real(1, 60), real(3, 5)};
      const glm::vec3 color = texture.over(box);
      const double want = reference::value<long double>(texture.image(), Wrap::kClamp, box, order(), 0);
      // The promises: 1e-3 of a level for integers, 0.01 for floats.
      EXPECT_NEAR(color.r, want, (is_float ? 0.01 : 1e-3) * kLevel);
    }
  }
}

TEST_P(RepeatedIntegration, AgreesOnBoxesThatAreCutForTheWord) {
  // A row of texels: 16-bit sums of order 3 hold 411 texels along it, so that these boxes take up to 30
  // pieces; order 2 would need 4,868.
  IntegralTexture texture(random_image(4096, 2, 11), Wrap::kClamp, order());
  for (int n = 0; n < 30; ++n) {
    const Box box{real(-100, 2500), real(-2, 2), real(60, 4000), real(1, 3)};
    const glm::vec3 color = texture.over(box);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(color[k], reference::value<long double>(texture.image(), Wrap::kClamp, box, order(), k),
                  1e-4 * kLevel);
    }
  }
}

TEST_P(RepeatedIntegration, StaysNearOnBoxesPastTheWord) {
  // Order 3 reads a coarser level here, the first or the second. Each has rounded its texels to 16 bits, by
  // half a step at most, 0.002 of a level. The weights are off by less than 1e-3 of themselves, of each
  // texel's difference from its neighbours: of white noise over a million texels nothing is left of that.
  IntegralTexture texture(random_image(1024, 1024, 12), Wrap::kRepeat, order());
  for (int n = 0; n < 5; ++n) {
    const Box box{real(0, 1024), real(0, 1024), real(800, 1000), real(800, 1000)};
    const glm::vec3 color = texture.over(box);
    EXPECT_NEAR(color.r, reference::value<long double>(texture.image(), Wrap::kRepeat, box, order(), 0),
                (order() == 3 ? 0.005 : 1e-4) * kLevel);
  }
}

TEST_P(RepeatedIntegration, KeepsConstantTexturesConstantToTheBit) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{31, 17}, std::pair{300, 5}}) {
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const Image images[] = {{width, height, 1, std::vector<std::uint16_t>(count, 40001)},
                            {width, height, 1, std::vector<float>(count, 0.7f)}};
    for (const Image& image : images) {
      for (const Wrap wrap : kWraps) {
        IntegralTexture texture(image, wrap, order());
        for (int n = 0; n < 300; ++n) {
          const Box box{real(-900, 900), real(-900, 900), std::exp2(real(-9, 14)), std::exp2(real(-9, 14))};
          EXPECT_EQ(texture.over(box), image.color(0, 0));
        }
      }
    }
  }
}

TEST_P(RepeatedIntegration, WidensBoxesNarrowerThanATexelToTheVarianceOfOne) {
  IntegralTexture texture(random_image(16, 16, 13), Wrap::kRepeat, order());
  const double least = 1 / std::sqrt(order());
  for (int n = 0; n < 200; ++n) {
    const glm::dvec2 middle(real(0, 16), real(0, 16));
    const double width = n % 4 == 0 ? 0 : std::exp2(real(-40, -1));
    const auto about = [&](double w) {
      return Box{middle.x - 0.5 * order() * w, middle.y - 0.5 * order() * w, w, w};
    };
    const double want =
        reference::value<long double>(texture.image(), Wrap::kRepeat, about(least), order(), n % 3);
    EXPECT_NEAR(texture.over(about(width))[n % 3], want, 1e-4 * kLevel);
  }
}

TEST_P(RepeatedIntegration, TakesAFootprintForItsVariance) {
  // n boxes of width w vary by n w^2 / 12, a tent of one step each way by the step's square over 6.
  IntegralTexture texture(random_image(64, 64, 14), Wrap::kRepeat, order());
  for (int n = 0; n < 100; ++n) {
    const glm::dvec2 dx(real(-3, 3), real(-3, 3));
    const glm::dvec2 dy(real(2, 3), real(2, 3));
    const glm::dvec2 at(real(0, 64), real(0, 64));
    const glm::dvec2 width = std::sqrt(2.0 / order()) * glm::sqrt(dx * dx + dy * dy);
    const Box box{at.x - 0.5 * order() * width.x, at.y - 0.5 * order() * width.y, width.x, width.y};
    const glm::dvec2 uv(at.x / 64, 1 - at.y / 64);
    EXPECT_NEAR(texture.sample({uv, dx / 64.0, dy / 64.0})[n % 3],
                reference::value<long double>(texture.image(), Wrap::kRepeat, box, order(), n % 3),
                1e-4 * kLevel);
  }
}

TEST_P(RepeatedIntegration, GivesTheMeanOfAllOverManyPeriods) {
  // A box of q periods and a rest of r differs from the mean by less than (r/w)^n, and not at all without
  // rest.
  for (const bool is_float : {false, true}) {
    for (const Wrap wrap : {Wrap::kRepeat, Wrap::kMirror}) {
      IntegralTexture texture(random_image(512, 256, 6, is_float), wrap, order());
      const glm::vec3 all = texture.over(UvBox{{0, 0}, {2.0 * order(), 2.0 * order()}});
      for (const double periods : {2.0, 1000.0, 1e6}) {
        const double side = order() * periods;
        const glm::vec3 mean = texture.over(UvBox{{0.25, 0.5}, {0.25 + side, 0.5 + side}});
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], all[k], 1e-7);
      }
    }
  }
}

TEST_P(RepeatedIntegration, ClampGoesOnWithTheBorderTexels) {
  // 1 x 4 texels 0, 1/3, 2/3, 1 in u; nothing changes in v.
  const Image ramp{4, 1, 1, std::vector<std::uint16_t>{0, 21845, 43690, 65535}};
  IntegralTexture texture(ramp, Wrap::kClamp, order());
  EXPECT_EQ(texture.over(UvBox{{-9, -9}, {0, 5}}).r, 0.0f);
  EXPECT_EQ(texture.over(UvBox{{1, 0}, {100, 1}}).r, 1.0f);
  // About the middle half is on either side, however wide.
  for (const double half : {0.5, 3.0, 1e3, 1e9})
    EXPECT_NEAR(texture.over(UvBox{{0.5 - half, 0}, {0.5 + half, 1}}).r, 0.5, 1e-7) << half;
  if (order() == 1) {
    // One image left of it to three right of it: 4 texels of 0, the image's mean of 1/2, 12 texels of 1.
    EXPECT_NEAR(texture.over(UvBox{{-1, 0}, {4, 1}}).r, (4 * 0 + 4 * 0.5 + 12) / 20.0, 1e-7);
  }
}

TEST_P(RepeatedIntegration, BoxesThatAreNoneGiveTheMeanOfAll) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Wrap wrap : kWraps) {
    IntegralTexture texture(random_image(16, 16, 7), wrap, order());
    const double all = reference::value<Whole>(texture.image(), wrap, {0, 0, 16, 16}, 1, 1);
    for (const UvBox& box :
         {UvBox{{nan, 0}, {1, 1}}, UvBox{{0, -infinity}, {1, 1}}, UvBox{{1, 1}, {0, 0}},
          UvBox{{0, 0}, {1e300, 1}}, UvBox{{-infinity, 0}, {infinity, 1}}, UvBox{{0, 0}, {1, nan}}})
      EXPECT_NEAR(texture.over(box).g, all, 1e-7);
  }
}

TEST_P(RepeatedIntegration, TheTopRowIsVOne) {
  const Image image{1, 2, 1, std::vector<std::uint16_t>{65535, 0}};
  IntegralTexture texture(image, Wrap::kClamp, order());
  EXPECT_EQ(texture.over(UvBox{{0, 0.5}, {1, 0.5 + 0.5 * order()}}).r, 1.0f);
}

TEST_P(RepeatedIntegration, IsTheSameHoweverFewTilesAreHeld) {
  const auto image = std::make_shared<const Image>(random_image(300, 700, 15));
  IntegralTexture plenty(image, Wrap::kMirror, order());
  // Two tiles; the sums at their borders go to a file.
  IntegralTexture few(image, Wrap::kMirror, order(), 200000);
  for (int n = 0; n < 500; ++n) {
    const Box box{real(-300, 600), real(-700, 1400), std::exp2(real(3, 9)), std::exp2(real(3, 9))};
    EXPECT_EQ(few.over(box), plenty.over(box));
  }
  EXPECT_EQ(plenty.counts().dropped, 0u);
  EXPECT_GT(few.counts().dropped, 0u);
  EXPECT_EQ(few.bytes_besides_tiles(), 0u);
  EXPECT_GT(plenty.bytes_besides_tiles(), 0u);
}

}  // namespace
}  // namespace sweepkit::texmap
