// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/texture_sampler.hpp"
#include "random_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <thread>
#include <vector>

namespace sweepkit::texmap {
namespace {

constexpr double kLevel = 1.0 / 255;

std::shared_ptr<const Image> random_image(int width, int height, bool is_float = false) {
  return std::make_shared<const Image>(
      test::random_image(width, height, static_cast<unsigned>(width * 31 + height), is_float));
}

std::int64_t wrapped(std::int64_t i, int size, Wrap wrap) {
  if (wrap == Wrap::kClamp) return std::clamp<std::int64_t>(i, 0, size - 1);
  const std::int64_t period = wrap == Wrap::kMirror ? 2 * size : size;
  const std::int64_t inside = ((i % period) + period) % period;
  return inside < size ? inside : period - 1 - inside;
}

constexpr Wrap kWraps[] = {Wrap::kRepeat, Wrap::kClamp, Wrap::kMirror};

// A lookup with a cache and a thread of its own.
glm::vec3 look_up(const std::shared_ptr<const Image>& image, Wrap wrap, Filter filter,
                  const Footprint& footprint) {
  TileCache cache;
  FilterThread thread(cache);
  return TextureSampler({image, wrap}, filter, cache, 0).sample(footprint, thread);
}

// The elliptical average written anew from its definition, over every texel of the finest level near by:
// weight (1 - q)^2, q = 1 at sqrt(8) standard deviations of the pixel's tent seen on the texture.
double elliptical_loop(const Image& image, Wrap wrap, const Footprint& f, int channel) {
  const glm::dvec2 size(image.width, -image.height);
  const glm::dvec2 dx = f.dx * size;
  const glm::dvec2 dy = f.dy * size;
  const glm::dmat2 step(dx, dy);
  const glm::dmat2 from_texels = glm::inverse(step);
  const double radius = std::sqrt(8.0 / 6);  // in pixels
  const auto reach = static_cast<std::int64_t>(2 * radius * (glm::length(dx) + glm::length(dy))) + 2;
  const glm::dvec2 middle = glm::dvec2(f.uv.x * image.width, (1 - f.uv.y) * image.height);
  double sum = 0;
  double weights = 0;
  for (std::int64_t y = std::llround(middle.y) - reach; y <= std::llround(middle.y) + reach; ++y) {
    for (std::int64_t x = std::llround(middle.x) - reach; x <= std::llround(middle.x) + reach; ++x) {
      const glm::dvec2 pixel =
          from_texels * (glm::dvec2(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5) - middle) /
          radius;
      const double q = glm::dot(pixel, pixel);
      if (q >= 1) continue;
      const double weight = (1 - q) * (1 - q);
      sum += weight *
             static_cast<double>(image.color(static_cast<int>(wrapped(x, image.width, wrap)),
                                             static_cast<int>(wrapped(y, image.height, wrap)))[channel]);
      weights += weight;
    }
  }
  return sum / weights;
}

Footprint footprint_in_texels(const Image& image, glm::dvec2 at, glm::dvec2 dx, glm::dvec2 dy) {
  const glm::dvec2 size(image.width, image.height);
  return {at / size, dx / size, dy / size};
}

TEST(Ewa, AgreesWithALoopOverTheFinestLevelWhereItReadsThat) {
  std::mt19937 random(1);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  for (const bool is_float : {false, true}) {
    // Sizes that are and are not multiples of a tile's; smaller and larger than one.
    for (const auto& [width, height] :
         {std::pair{200, 130}, std::pair{64, 64}, std::pair{5, 9}, std::pair{1, 3}}) {
      const auto image = random_image(width, height, is_float);
      for (const Wrap wrap : kWraps) {
        for (int n = 0; n < 100; ++n) {
          // The minor axis between 1.3 and 2.4 steps of a texel: wide enough to need no widening, too narrow
          // for the next level. Steps at right angles are the axes.
          const double angle = real(0, 2 * std::numbers::pi);
          const glm::dvec2 along(std::cos(angle), std::sin(angle));
          const glm::dvec2 dx = real(1.3, 2.4) * along;
          const glm::dvec2 dy =
              real(1.3, std::min(20.0, 1.3 * std::min(width, height))) * glm::dvec2(-along.y, along.x);
          const Footprint f = footprint_in_texels(
              *image, {real(-3 * width, 3 * width), real(-3 * height, 3 * height)}, dx, dy);
          const glm::vec3 color = look_up(image, wrap, Filter::kEwa, f);
          // The weights are float32: some 1e-6 of a level's sum.
          for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(color[k], elliptical_loop(*image, wrap, f, k), 1e-2 * kLevel);
        }
      }
    }
  }
}

TEST(Ewa, StaysNearTheLoopOnCoarserLevels) {
  // Random texels are the worst texture: every level's texels are rounded to that level's grid.
  std::mt19937 random(2);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  const auto image = random_image(256, 256);
  double squares = 0;
  int count = 0;
  for (int n = 0; n < 60; ++n) {
    const double angle = real(0, 2 * std::numbers::pi);
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    const double step = real(4, 20);
    const Footprint f = footprint_in_texels(*image, {real(0, 256), real(0, 256)}, step * along,
                                            real(1, 3) * step * glm::dvec2(-along.y, along.x));
    const double difference =
        look_up(image, Wrap::kRepeat, Filter::kEwa, f).r - elliptical_loop(*image, Wrap::kRepeat, f, 0);
    squares += difference * difference;
    ++count;
  }
  // White noise averaged over a footprint of s by t texels has a standard deviation of 0.29 / sqrt(s t), 0.02
  // in the middle of this range; what the levels change is a fraction of that.
  EXPECT_LT(std::sqrt(squares / count), 0.006);
}

TEST(Samplers, KeepAConstantTextureConstantForEveryFootprint) {
  std::mt19937 random(3);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{33, 7}, std::pair{128, 128}}) {
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::shared_ptr<const Image> images[] = {
        std::make_shared<const Image>(Image{width, height, 1, std::vector<std::uint16_t>(count, 43210)}),
        std::make_shared<const Image>(Image{width, height, 1, std::vector<float>(count, 0.7f)})};
    for (const auto& image : images) {
      const float value = image->color(0, 0).r;
      for (const Wrap wrap : kWraps) {
        for (std::size_t filter = 0; filter < kFilterNames.size(); ++filter) {
          TileCache cache;
          FilterThread thread(cache);
          const TextureSampler sampler({image, wrap}, static_cast<Filter>(filter), cache, 0);
          for (int n = 0; n < 1000; ++n) {
            const auto vector = [&] {
              const double size = std::pow(10, real(-9, 4));  // by itself: arguments come in any order
              const double u = real(-1, 1);
              return size * glm::dvec2(u, real(-1, 1));
            };
            const Footprint f{{real(-5, 5), real(-5, 5)}, vector(), vector()};
            // Sums of some thousand terms in float32.
            EXPECT_NEAR(sampler.sample(f, thread).r, value, 1e-3 * kLevel) << kFilterNames[filter];
          }
        }
      }
    }
  }
}

TEST(Samplers, TakeFootprintsOfEverySizeAndKind) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double kinds[] = {0, 5e-324, 1e-30, 1e-3, 1, 1e3, 1e18, 1e300, infinity, nan, -1e-3, -infinity};
  const auto image = random_image(37, 70);
  for (const Wrap wrap : kWraps) {
    for (std::size_t filter = 1; filter < kFilterNames.size(); ++filter) {
      TileCache cache;
      FilterThread thread(cache);
      const TextureSampler sampler({image, wrap}, static_cast<Filter>(filter), cache, 0);
      for (const double u : kinds) {
        for (const double a : kinds) {
          for (const double b : kinds) {
            for (const Footprint& f :
                 {Footprint{{u, 0.3}, {a, 0}, {0, b}}, Footprint{{0.3, u}, {a, b}, {b, a}}}) {
              const glm::vec3 color = sampler.sample(f, thread);
              for (int k = 0; k < 3; ++k) {
                EXPECT_GE(color[k], 0) << kFilterNames[filter] << ' ' << u << ' ' << a << ' ' << b;
                EXPECT_LE(color[k], 1.000001f) << kFilterNames[filter] << ' ' << u << ' ' << a << ' ' << b;
              }
            }
          }
        }
      }
    }
  }
}

TEST(Samplers, GiveTheMeanOfTheTextureWhereThePixelCoversAllOfIt) {
  const auto image = random_image(48, 20);
  glm::dvec3 mean(0.0);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 48; ++x) mean += glm::dvec3(image->color(x, y)) / (48.0 * 20);
  }
  for (const Filter filter : {Filter::kTrilinear, Filter::kIntegral1, Filter::kIntegral2, Filter::kIntegral3,
                              Filter::kEwa, Filter::kAuto}) {
    for (const double size : {30.0, 1e6, std::numeric_limits<double>::infinity()}) {
      // A box of 42.4 periods holds a part of one more often than the rest.
      if (filter == Filter::kIntegral1 && size == 30) continue;
      for (const Wrap wrap : {Wrap::kRepeat, Wrap::kMirror}) {
        const glm::vec3 color = look_up(image, wrap, filter, {{0.2, 0.7}, {size, 0}, {0, size}});
        // Each of at most 6 levels rounds to 16 bits.
        for (int k = 0; k < 3; ++k)
          EXPECT_NEAR(color[k], mean[k], 0.05 * kLevel) << filter_name(filter) << size;
      }
    }
  }
}

TEST(Samplers, ClampedTexturesShowTheirEdgeFarOutside) {
  Image image{8, 8, 1, std::vector<std::uint16_t>(64, 20000)};
  auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
  for (std::size_t y = 0; y < 8; ++y) texels[8 * y + 7] = 50000;  // the right column
  const auto shared = std::make_shared<const Image>(std::move(image));
  for (std::size_t filter = 0; filter < kFilterNames.size(); ++filter) {
    for (const double u : {1.5, 30.0, 1e12}) {
      const glm::vec3 color =
          look_up(shared, Wrap::kClamp, static_cast<Filter>(filter), {{u, 0.4}, {0.01, 0}, {0, 0.01}});
      EXPECT_NEAR(color.r, 50000 / 65535.0, 1e-6) << kFilterNames[filter] << ' ' << u;
    }
  }
}

TEST(Bilinear, IsLinearBetweenTheMiddlesOfTexels) {
  const auto image = std::make_shared<const Image>(Image{2, 2, 1, std::vector<float>{0, 1, 2, 3}});
  const auto at = [&](double x, double y, Wrap wrap) {
    return look_up(image, wrap, Filter::kBilinear, {{x / 2, 1 - y / 2}}).r;
  };
  for (const Wrap wrap : kWraps) {
    EXPECT_EQ(at(0.5, 0.5, wrap), 0);
    EXPECT_EQ(at(1.25, 0.5, wrap), 0.75f);
    EXPECT_EQ(at(1, 1, wrap), 1.5f);
  }
  EXPECT_EQ(at(0, 0.5, Wrap::kRepeat), 0.5f);
  EXPECT_EQ(at(0, 0.5, Wrap::kClamp), 0);
  EXPECT_EQ(at(0, 0.5, Wrap::kMirror), 0);
  EXPECT_EQ(at(2.5, 0.5, Wrap::kMirror), 1);
  EXPECT_EQ(at(3.5, 0.5, Wrap::kMirror), 0);
}

TEST(Auto, IsBilinearWhereTheTextureIsMagnifiedAndEllipticalElsewhere) {
  const auto image = random_image(64, 64);
  const Footprint near{{0.31, 0.47}, {0.4 / 64, 0.1 / 64}, {-0.1 / 64, 0.4 / 64}};
  const Footprint far{{0.31, 0.47}, {3.0 / 64, 1.0 / 64}, {-1.0 / 64, 9.0 / 64}};
  EXPECT_EQ(look_up(image, Wrap::kRepeat, Filter::kAuto, near),
            look_up(image, Wrap::kRepeat, Filter::kBilinear, near));
  EXPECT_EQ(look_up(image, Wrap::kRepeat, Filter::kAuto, far),
            look_up(image, Wrap::kRepeat, Filter::kEwa, far));
}

// A floor 1 below the eye that runs to the horizon, 64 x 64 pixels; the texture's period is 2. Where pixel
// (x, y) looks, or nothing within two degrees of the horizon.
std::optional<glm::dvec2> floor_uv(double x, double y) {
  const double fall = (y / 64 - 0.1) * 1.2;
  if (fall < 0.035) return std::nullopt;
  const glm::dvec2 at = glm::dvec2((x / 64 - 0.5) * 1.2, 1) / fall;
  // Turned, so that no axis of the texture is one of the footprints.
  return 0.5 * glm::dvec2(0.8 * at.x - 0.6 * at.y, 0.6 * at.x + 0.8 * at.y);
}

TEST(Auto, IsWithinHalfADecibelOfEwaOnAFloorThatRunsToTheHorizon) {
  // Noise of equal strength in every octave, so that every level of the pyramid counts.
  constexpr int kSide = 256;
  std::vector<float> texels(kSide * kSide, 0.5f);
  for (int cell = 1; cell <= 64; cell *= 2) {
    const auto octave = random_image(kSide / cell, kSide / cell, true);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x)
        texels[static_cast<std::size_t>(y * kSide + x)] +=
            0.1f * (octave->color(x / cell, y / cell).r - 0.5f);
    }
  }
  const ImageTexture texture{std::make_shared<const Image>(Image{kSide, kSide, 1, texels})};
  TileCache cache;
  FilterThread thread(cache);
  const TextureSampler ewa(texture, Filter::kEwa, cache, 0);
  const TextureSampler automatic(texture, Filter::kAuto, cache, 1);
  double of_ewa = 0;
  double of_auto = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      if (!floor_uv(x, y - 1.5)) continue;
      const auto at = [&](double dx, double dy) { return *floor_uv(x + 0.5 + dx, y + 0.5 + dy); };
      const Footprint f{at(0, 0), at(0.5, 0) - at(-0.5, 0), at(0, 0.5) - at(0, -0.5)};
      double sum = 0;
      double weights = 0;
      for (int j = -15; j < 16; ++j) {
        for (int i = -15; i < 16; ++i) {
          const double weight = (16 - std::abs(i)) * (16 - std::abs(j));
          sum +=
              weight * static_cast<double>(point_sample(texture, at(i / 16.0, j / 16.0), glm::dvec3(0.0)).r);
          weights += weight;
        }
      }
      const double expected = sum / weights;
      of_ewa += std::pow(static_cast<double>(ewa.sample(f, thread).r) - expected, 2);
      of_auto += std::pow(static_cast<double>(automatic.sample(f, thread).r) - expected, 2);
    }
  }
  EXPECT_LT(10 * std::log10(of_auto / of_ewa), 0.5);
}

TEST(TileCache, GivesTheSameTexelsHoweverFewTilesItHolds) {
  const auto image = random_image(700, 500);
  TileCache large;
  TileCache small(200000);  // six tiles
  std::vector<Footprint> footprints;
  std::mt19937 random(5);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  for (int n = 0; n < 3000; ++n) {
    const double size = std::pow(2, real(-9, 0));
    footprints.push_back({{real(-1, 2), real(-1, 2)},
                          {size * real(-1, 1), size * real(-1, 1)},
                          {size * real(-1, 1), size * real(-1, 1)}});
  }
  const auto sample_all = [&](TileCache& cache, std::vector<glm::vec3>& colors) {
    const TextureSampler sampler({image, Wrap::kRepeat}, Filter::kEwa, cache, 3);
    FilterThread thread(cache);
    for (const Footprint& f : footprints) colors.push_back(sampler.sample(f, thread));
  };
  std::vector<glm::vec3> of_large;
  sample_all(large, of_large);
  std::vector<std::vector<glm::vec3>> of_small(4);
  std::vector<std::thread> threads;
  for (std::vector<glm::vec3>& colors : of_small) threads.emplace_back([&] { sample_all(small, colors); });
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<glm::vec3>& colors : of_small) EXPECT_EQ(colors, of_large);
  EXPECT_EQ(large.counts().dropped, 0u);
  EXPECT_GT(small.counts().dropped, 0u);
}

TEST(TileCache, StaysWithinItsBoundAndWhatItsReadersHold) {
  const auto image = random_image(2048, 2048);
  constexpr std::size_t kBound = 1 << 20;
  TileCache cache(kBound);
  const TextureSampler sampler({image, Wrap::kRepeat}, Filter::kBilinear, cache, 0);
  {
    FilterThread thread(cache);
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 32; ++x) sampler.sample({{(x + 0.5) / 32, (y + 0.5) / 32}}, thread);
    }
  }
  constexpr std::size_t kTile = 64 * 64 * 8;
  const TileCache::Counts counts = cache.counts();
  EXPECT_EQ(counts.made, 1024u);
  EXPECT_LE(counts.peak_bytes, kBound + 129 * kTile);
  EXPECT_EQ(counts.made - counts.dropped, counts.bytes / kTile);
}

}  // namespace
}  // namespace sweepkit::texmap
