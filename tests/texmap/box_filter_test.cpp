// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "random_image.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"

namespace sweepkit::texmap {
namespace {

constexpr Wrap kWraps[] = {Wrap::kRepeat, Wrap::kClamp, Wrap::kMirror};

glm::vec3 look_up(const std::shared_ptr<const Image>& image, Wrap wrap, Filter filter,
                  const Footprint& footprint) {
  TileCache cache;
  FilterThread thread(cache);
  return TextureSampler({image, wrap}, filter, cache, 0).sample(footprint, thread);
}

// The mean over the pixel by n x n points, each in its texel: a point set that is off by what its squares
// differ from the texels' shares.
double mean_of_points(const std::shared_ptr<const Image>& image, Wrap wrap, const Footprint& f, int n) {
  TileCache cache;
  FilterThread thread(cache);
  const TextureSampler nearest({image, wrap}, Filter::kPoint, cache, 0);
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const glm::dvec2 uv = f.uv + ((i + 0.5) / n - 0.5) * f.dx + ((k + 0.5) / n - 0.5) * f.dy;
      sum += static_cast<double>(nearest.sample({uv}, thread).r);
    }
  }
  return sum / (n * n);
}

struct Random {
  std::mt19937 generator{5};
  double operator()(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(generator);
  }
};

TEST(BoxFilter, IsTheShareOfEveryTexelAlongTheTexturesAxes) {
  Random real;
  for (const bool is_float : {false, true}) {
    for (const auto& [width, height] : {std::pair{200, 130}, std::pair{64, 64}, std::pair{5, 9}}) {
      const auto image = std::make_shared<const Image>(test::random_image(width, height, 1, is_float));
      for (const Wrap wrap : kWraps) {
        for (int n = 0; n < 25; ++n) {
          const glm::dvec2 size(width, height);
          // At least 2 texels wide and under 4, where the finest level is read.
          const Footprint f{glm::dvec2(real(-1, 2), real(-1, 2)), glm::dvec2(real(2.1, 3.9), 0) / size,
                            glm::dvec2(0, real(2.1, 3.9)) / size};
          double sum = 0;
          double weights = 0;
          const glm::dvec2 low = (f.uv - 0.5 * (f.dx + f.dy)) * size;
          const glm::dvec2 high = (f.uv + 0.5 * (f.dx + f.dy)) * size;
          for (double y = std::floor(low.y); y < high.y; ++y) {
            for (double x = std::floor(low.x); x < high.x; ++x) {
              const double weight = (std::min(x + 1, high.x) - std::max(x, low.x)) *
                                    (std::min(y + 1, high.y) - std::max(y, low.y));
              sum += weight * static_cast<double>(
                                  look_up(image, wrap, Filter::kPoint, {(glm::dvec2(x, y) + 0.5) / size}).r);
              weights += weight;
            }
          }
          // Weights in float32, some ten texels.
          EXPECT_NEAR(look_up(image, wrap, Filter::kBox, f).r, sum / weights, 1e-5);
        }
      }
    }
  }
}

TEST(BoxFilter, IsNearTheMeanUnderTurnedPixels) {
  Random real;
  const auto image = std::make_shared<const Image>(test::random_image(256, 256, 2));
  double squares = 0;
  double of_ellipse = 0;
  constexpr int kCount = 150;
  for (int n = 0; n < kCount; ++n) {
    const double angle = real(0, 2 * std::numbers::pi);
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    const double step = real(2, 4) / 256;
    const Footprint f{glm::dvec2(real(0, 1), real(0, 1)), step * along,
                      real(1, 6) * step * (glm::dvec2(-along.y, along.x) + real(-0.5, 0.5) * along)};
    const double expected = mean_of_points(image, Wrap::kRepeat, f, 64);
    const double box = static_cast<double>(look_up(image, Wrap::kRepeat, Filter::kBox, f).r) - expected;
    const double ewa = static_cast<double>(look_up(image, Wrap::kRepeat, Filter::kEwa, f).r) - expected;
    squares += box * box;
    of_ellipse += ewa * ewa;
  }
  // Texels at random are the worst texture: the mean of 20 has a standard deviation of 0.29 / sqrt(20) =
  // 0.065. What the texels on the pixel's edge are weighed wrong is a part of that, half at the most.
  EXPECT_LT(std::sqrt(squares / kCount), 0.03);
  EXPECT_LT(squares, of_ellipse);
}

TEST(BoxFilter, CutsTexelsThatAreWiderThanThePixel) {
  // Bands: one texel round, many along. A pixel that is narrow round and askew sees several of them.
  Random real;
  const auto image = std::make_shared<const Image>(test::random_image(4, 256, 3));
  for (int n = 0; n < 100; ++n) {
    const Footprint f{glm::dvec2(real(0, 1), real(0, 1)), glm::dvec2(real(0.005, 0.02), real(-1, 1) / 256),
                      glm::dvec2(real(-0.005, 0.005), real(2, 6) / 256)};
    // Points: 64 rows over at most 7 texels, each row's part in a texel to 1/64 of the pixel.
    EXPECT_NEAR(look_up(image, Wrap::kRepeat, Filter::kBox, f).r, mean_of_points(image, Wrap::kRepeat, f, 64),
                0.05);
  }
}

TEST(BoxFilter, TakesStepsThatRoundingHasTurnedFromTheAxes) {
  // Off the axes by some 1e-15 of a texel: rows beside the pixel are then as far as 1e15 texels from it.
  const auto image = std::make_shared<const Image>(test::random_image(64, 64, 6));
  for (const double off : {0.0, 1e-16, -1e-16, 1e-18, -1e-18}) {
    for (const double width : {0.46, 2.08}) {
      const Footprint f{{0.96, 0.745}, {width / 64, off}, {0.05 / 64, 2.1 / 64}};
      const Footprint straight{f.uv, {width / 64, 0}, f.dy};
      EXPECT_NEAR(look_up(image, Wrap::kRepeat, Filter::kBox, f).r,
                  look_up(image, Wrap::kRepeat, Filter::kBox, straight).r, 1e-5);
    }
  }
}

TEST(BoxFilter, IsBilinearWhereTheTextureIsMagnified) {
  const auto image = std::make_shared<const Image>(test::random_image(16, 16, 4));
  const Footprint f{{0.3, 0.6}, {0.02, 0.01}, {-0.01, 0.02}};
  EXPECT_EQ(look_up(image, Wrap::kRepeat, Filter::kBox, f),
            look_up(image, Wrap::kRepeat, Filter::kBilinear, f));
}

}  // namespace
}  // namespace sweepkit::texmap
