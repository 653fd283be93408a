// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/summed_area_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace sweepkit::texmap {
namespace {

Image random_image(int width, int height, unsigned seed, bool is_float = false) {
  std::mt19937 random(seed);
  const std::size_t count = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Image image{width, height, 3, {}};
  if (is_float) {
    std::vector<float> texels(count);
    for (float& t : texels) t = std::uniform_real_distribution<float>(0, 1)(random);
    image.texels = std::move(texels);
  } else {
    std::vector<std::uint16_t> texels(count);
    for (std::uint16_t& t : texels) t = static_cast<std::uint16_t>(random());
    image.texels = std::move(texels);
  }
  return image;
}

int wrapped(std::int64_t i, int size, Wrap wrap) {
  if (wrap == Wrap::kClamp) return static_cast<int>(std::clamp<std::int64_t>(i, 0, size - 1));
  return static_cast<int>(((i % size) + size) % size);
}

// The mean by a loop over every texel the box touches, in long double. Texel units, y down.
double loop_mean(const Image& image, Wrap wrap, double x0, double x1, double y0, double y1, int channel) {
  long double sum = 0;
  for (auto j = static_cast<std::int64_t>(std::floor(y0)); static_cast<double>(j) < y1; ++j) {
    const long double height = std::min<long double>(y1, static_cast<long double>(j + 1)) -
                               std::max<long double>(y0, static_cast<long double>(j));
    for (auto i = static_cast<std::int64_t>(std::floor(x0)); static_cast<double>(i) < x1; ++i) {
      const long double width = std::min<long double>(x1, static_cast<long double>(i + 1)) -
                                std::max<long double>(x0, static_cast<long double>(i));
      sum += width * height *
             image.color(wrapped(i, image.width, wrap), wrapped(j, image.height, wrap))[channel];
    }
  }
  return static_cast<double>(sum /
                             ((static_cast<long double>(x1) - x0) * (static_cast<long double>(y1) - y0)));
}

UvBox uv_box(const Image& image, double x0, double x1, double y0, double y1) {
  return {{x0 / image.width, 1 - y1 / image.height}, {x1 / image.width, 1 - y0 / image.height}};
}

// A level of 8 bits; promises are told in it.
constexpr double kLevel = 1.0 / 255;

TEST(SummedAreaTable, AgreesWithALoopOnEveryBoxOfASmallImage) {
  const Image image = random_image(8, 4, 1);  // powers of two: (u,v) name the corners exactly
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClamp}) {
    const SummedAreaTable table(image, wrap);
    for (int x0 = -9; x0 < 10; ++x0) {
      for (int x1 = x0 + 1; x1 < 19; x1 += 3) {
        for (int y0 = -5; y0 < 6; ++y0) {
          for (int y1 = y0 + 1; y1 < 11; y1 += 2) {
            const glm::vec3 mean = table.mean(uv_box(image, x0, x1, y0, y1));
            // The table is exact; what is left is the loop's texels and the result being float32.
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], loop_mean(image, wrap, x0, x1, y0, y1, k), 2e-7);
          }
        }
      }
    }
  }
}

TEST(SummedAreaTable, IsExactForIntegerCornersOfALargeTable) {
  // Sixteen-bit texels, all the largest but one in each 16: sums near the top of what the table holds.
  Image image{4096, 4096, 1, std::vector<std::uint16_t>(4096 * 4096, 65535)};
  auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
  for (std::size_t i = 0; i < texels.size(); i += 16) texels[i] = 0;
  const SummedAreaTable table(image, Wrap::kRepeat);
  std::mt19937 random(2);
  for (int n = 0; n < 10000; ++n) {
    const int x0 = 16 * static_cast<int>(random() % 256);
    const int x1 = x0 + 16 * (1 + static_cast<int>(random() % 255));
    const int y0 = static_cast<int>(random() % 4096);
    const int y1 = y0 + 1 + static_cast<int>(random() % 4096);
    EXPECT_EQ(table.mean(uv_box(image, x0, x1, y0, y1)).r, 0.9375f);  // 15 of 16, whole columns of 16
  }
}

TEST(SummedAreaTable, AgreesWithALoopOnFractionalBoxes) {
  std::mt19937 random(3);
  for (const bool is_float : {false, true}) {
    for (const auto& [width, height] : {std::pair{7, 5}, std::pair{64, 64}, std::pair{200, 100}}) {
      const Image image = random_image(width, height, 4, is_float);
      for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClamp}) {
        const SummedAreaTable table(image, wrap);
        for (int n = 0; n < 100; ++n) {
          const auto real = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
          };
          const double x0 = real(-2 * width, 2 * width);
          const double y0 = real(-2 * height, 2 * height);
          const double x1 = x0 + real(1, 1.5 * width);
          const double y1 = y0 + real(1, 1.5 * height);
          const glm::vec3 mean = table.mean(uv_box(image, x0, x1, y0, y1));
          for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(mean[k], loop_mean(image, wrap, x0, x1, y0, y1, k), 1e-3 * kLevel);
        }
      }
    }
  }
}

TEST(SummedAreaTable, ConstantTexturesComeBackConstant) {
  std::mt19937 random(5);
  const Image integers{31, 17, 1, std::vector<std::uint16_t>(31 * 17, 40000)};
  const Image floats{31, 17, 1, std::vector<float>(31 * 17, 0.7f)};
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClamp}) {
    const SummedAreaTable of_integers(integers, wrap);
    const SummedAreaTable of_floats(floats, wrap);
    for (int n = 0; n < 2000; ++n) {
      const auto real = [&] { return std::uniform_real_distribution<double>(-30, 30)(random); };
      const glm::dvec2 corner(real(), real());
      const UvBox box{corner, corner + glm::abs(glm::dvec2(real(), real()))};
      EXPECT_NEAR(of_integers.mean(box).g, 40000 / 65535.0, 1e-7);
      EXPECT_NEAR(of_floats.mean(box).b, 0.7, 1e-6);
    }
  }
}

TEST(SummedAreaTable, ABoxSmallerThanATexelIsBilinearInterpolation) {
  const Image image{2, 1, 1, std::vector<std::uint16_t>{0, 65535}};
  const SummedAreaTable table(image, Wrap::kClamp);
  for (const double x : {0.5, 0.75, 1.0, 1.3, 1.5}) {
    EXPECT_NEAR(table.mean({{x / 2, 0.5}, {x / 2, 0.5}}).r, x - 0.5, 1e-6);
  }
}

TEST(SummedAreaTable, ManyPeriodsGiveTheMeanOfAll) {
  for (const bool is_float : {false, true}) {
    const Image image = random_image(512, 256, 6, is_float);
    const SummedAreaTable table(image, Wrap::kRepeat);
    const glm::vec3 all = table.mean({{0, 0}, {1, 1}});
    for (const double periods : {3.0, 1000.0, 1e6}) {
      const glm::vec3 mean = table.mean({{0.25, 0.5}, {0.25 + periods, 0.5 + periods}});
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], all[k], 1e-7);
    }
  }
}

TEST(SummedAreaTable, WhiteStaysWhiteOverAMillionTurns) {
  // The sum of such a box, 65535 x 2^18 x 1e12, is far past 2^64.
  const Image white{512, 512, 1, std::vector<std::uint16_t>(512 * 512, 65535)};
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClamp}) {
    const SummedAreaTable table(white, wrap);
    EXPECT_EQ(table.mean({{-1e6, -1e6}, {1e6, 1e6}}).r, 1.0f);
    EXPECT_EQ(table.mean({{-1e6, 0.1}, {1e6 + 0.3, 0.2}}).r, 1.0f);
    EXPECT_EQ(table.mean({{-1e12, -1e12}, {1e12, 1e12}}).r, 1.0f);
  }
}

TEST(SummedAreaTable, ClampGoesOnWithTheBorderTexels) {
  // 1 x 4 texels 0, 1/3, 2/3, 1 in u; nothing changes in v.
  const Image ramp{4, 1, 1, std::vector<std::uint16_t>{0, 21845, 43690, 65535}};
  const SummedAreaTable table(ramp, Wrap::kClamp);
  EXPECT_EQ(table.mean({{-9, -9}, {-1, 5}}).r, 0.0f);
  EXPECT_EQ(table.mean({{1, 0}, {100, 1}}).r, 1.0f);
  // From one image left of it to three right of it: 4 texels of 0, the image's mean of 1/2, 12 texels of 1.
  EXPECT_NEAR(table.mean({{-1, 0}, {4, 1}}).r, (4 * 0 + 4 * 0.5 + 12) / 20.0, 1e-7);
}

// The mean by weights: how much of the box each column and each row holds. A second way to the same figure,
// quick enough for boxes of any size.
std::vector<double> shares(double from, double to, int size, Wrap wrap) {
  std::vector<double> share(static_cast<std::size_t>(size));
  for (auto i = static_cast<std::int64_t>(std::floor(from)); static_cast<double>(i) < to; ++i) {
    const double low = std::max(from, static_cast<double>(i));
    const double high = std::min(to, static_cast<double>(i + 1));
    share[static_cast<std::size_t>(wrapped(i, size, wrap))] += (high - low) / (to - from);
  }
  return share;
}

double weighted_mean(const Image& image, Wrap wrap, double x0, double x1, double y0, double y1, int channel) {
  const std::vector<double> across = shares(x0, x1, image.width, wrap);
  const std::vector<double> down = shares(y0, y1, image.height, wrap);
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    if (down[static_cast<std::size_t>(y)] == 0) continue;
    double row = 0;
    for (int x = 0; x < image.width; ++x)
      row += across[static_cast<std::size_t>(x)] * image.color(x, y)[channel];
    sum += down[static_cast<std::size_t>(y)] * row;
  }
  return sum;
}

TEST(SummedAreaTable, AgreesWithColumnAndRowSharesOnBoxesOfEverySize) {
  std::mt19937 random(8);
  for (const bool is_float : {false, true}) {
    const Image image = random_image(512, 512, 9, is_float);
    for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClamp}) {
      const SummedAreaTable table(image, wrap);
      for (int n = 0; n < 60; ++n) {
        const auto real = [&](double low, double high) {
          return std::uniform_real_distribution<double>(low, high)(random);
        };
        // Sides from 1 to 8192 texels, all sizes alike; up to 16 images away.
        const double x0 = real(-8192, 8192);
        const double y0 = real(-8192, 8192);
        const double x1 = x0 + std::exp2(real(0, 13));
        const double y1 = y0 + std::exp2(real(0, 13));
        const double want = weighted_mean(image, wrap, x0, x1, y0, y1, n % 3);
        EXPECT_NEAR(table.mean(uv_box(image, x0, x1, y0, y1))[n % 3], want, 1e-3 * kLevel)
            << x0 << " " << x1 << " " << y0 << " " << y1;
      }
    }
  }
}

TEST(SummedAreaTable, LosesNothingAtTheFarCornerOfALargeTable) {
  // A texel or two where the sums are largest: there a table in float32 is hundreds of levels off.
  std::mt19937 random(10);
  for (const bool is_float : {false, true}) {
    const int size = is_float ? 1024 : 4096;
    Image image{size, size, 1, {}};
    const auto count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    if (is_float) {
      std::vector<float> texels(count);
      for (float& t : texels) t = static_cast<float>(random() % 65536) / 65535;
      image.texels = std::move(texels);
    } else {
      std::vector<std::uint16_t> texels(count);
      for (std::uint16_t& t : texels) t = static_cast<std::uint16_t>(random());
      image.texels = std::move(texels);
    }
    const SummedAreaTable table(image, Wrap::kClamp);
    for (int n = 0; n < 1000; ++n) {
      const auto real = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
      };
      const double x0 = size - real(2, 40);
      const double y0 = size - real(2, 40);
      const double x1 = std::min(x0 + real(1, 3), 1.0 * size);
      const double y1 = std::min(y0 + real(1, 3), 1.0 * size);
      const double want = loop_mean(image, Wrap::kClamp, x0, x1, y0, y1, 0);
      // The promises: 1e-3 of a level for integers, 0.01 for floats.
      EXPECT_NEAR(table.mean(uv_box(image, x0, x1, y0, y1)).r, want, (is_float ? 0.01 : 1e-3) * kLevel);
    }
  }
}

TEST(SummedAreaTable, BoxesThatAreNoneGiveTheMeanOfAll) {
  const Image image = random_image(16, 16, 7);
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClamp}) {
    const SummedAreaTable table(image, wrap);
    const glm::vec3 all = table.mean({{0, 0}, {1, 1}});
    EXPECT_EQ(table.mean({{nan, 0}, {1, 1}}), all);
    EXPECT_EQ(table.mean({{0, -infinity}, {1, 1}}), all);
    EXPECT_EQ(table.mean({{1, 1}, {0, 0}}), all);
    EXPECT_EQ(table.mean({{0, 0}, {1e300, 1}}), all);
  }
}

TEST(SummedAreaTable, TheTopRowIsVOne) {
  const Image image{1, 2, 1, std::vector<std::uint16_t>{65535, 0}};
  EXPECT_EQ(SummedAreaTable(image, Wrap::kClamp).mean({{0, 0.5}, {1, 1}}).r, 1.0f);
}

}  // namespace
}  // namespace sweepkit::texmap
