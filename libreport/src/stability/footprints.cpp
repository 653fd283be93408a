// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/footprint.hpp"

#include <memory>
#include <random>

#include "stability/stability_case.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kStage = "footprints";
constexpr const char* kInRange = "texture filters: any footprint gives a mean of texels, never NaN";
constexpr const char* kWraps = "texture filters: a repeated texture is the same after whole repeats";
constexpr double kLevel = 1.0 / 255;
constexpr int kSide = 64;

constexpr texmap::Filter kFilters[] = {
    texmap::Filter::kPoint,     texmap::Filter::kBilinear,  texmap::Filter::kTrilinear,
    texmap::Filter::kIntegral1, texmap::Filter::kIntegral2, texmap::Filter::kIntegral3,
    texmap::Filter::kEwa,       texmap::Filter::kBox,       texmap::Filter::kAuto};

// Texels from 1/4 to 3/4: what is no mean of them shows.
std::shared_ptr<const texmap::Image> noise() {
  texmap::Image image{kSide, kSide, 1, std::vector<std::uint16_t>()};
  std::mt19937 random(1);
  for (int i = 0; i < kSide * kSide; ++i)
    std::get<std::vector<std::uint16_t>>(image.texels)
        .push_back(static_cast<std::uint16_t>(16384 + random() % 32768));
  return std::make_shared<const texmap::Image>(std::move(image));
}

double mean_of(const texmap::Image& image) {
  double sum = 0;
  for (const std::uint16_t texel : std::get<std::vector<std::uint16_t>>(image.texels)) sum += texel;
  return sum / 65535 / (kSide * kSide);
}

// Calls `look` with every filter; the worst of what it returns.
template <class Look>
double over_filters(Look&& look) {
  const auto image = noise();
  double worst = 0;
  for (const texmap::Filter filter : kFilters) {
    texmap::TileCache cache(texmap::kDefaultTextureMemory);
    const texmap::TextureSampler sampler({image, texmap::Wrap::kRepeat}, filter, cache, 0);
    texmap::FilterThread thread(cache);
    const auto sample = [&](const texmap::Footprint& footprint) {
      return static_cast<double>(sampler.sample(footprint, thread).x);
    };
    worst = worse(worst, look(*image, filter, sample));
  }
  return worst;
}

double out_of_range(double value) {
  return std::isfinite(value) ? std::max({0.0, 16384 / 65535.0 - value, value - 49152 / 65535.0}) / kLevel
                              : NAN;
}

StabilityCase in_range(const std::string& name, const std::string& input, double hardness,
                       const std::string& hardness_is, glm::dvec2 dx, glm::dvec2 dy) {
  return {.name = "footprints_" + name,
          .stage = kStage,
          .input = input + ", every filter",
          .hardness = hardness,
          .hardness_is = hardness_is,
          .promise = kInRange,
          .unit = "8-bit levels outside of the texels' range",
          .run = [dx, dy] {
            const double worst = over_filters([&](const auto&, texmap::Filter, const auto& sample) {
              double most = 0;
              for (int n = 0; n < 16; ++n) {
                const glm::dvec2 uv(0.37 * n, 0.73 * n);
                most = worse(most, out_of_range(sample({uv, dx, dy})));
              }
              return most;
            });
            // Of the result's own float32 step.
            return Reached{.error = worst, .bound = 0x1p-24 / kLevel};
          }};
}

StabilityCase whole_texture(double repeats, const std::string& power) {
  return {.name = "footprints_whole_" + power,
          .stage = kStage,
          .input = "boxes and a pixel that cover " + power + " whole repeats each way, tables and a pyramid",
          .hardness = kSide * repeats,
          .hardness_is = "texels across the pixel",
          .promise = "table filters: within 1e-3 of an 8-bit level (pyramids: rounded once a level)",
          .unit = "8-bit levels from the mean",
          .run = [repeats] {
            const auto image = noise();
            const double mean = mean_of(*image);
            double worst = 0;
            for (const texmap::Filter filter : {texmap::Filter::kTrilinear, texmap::Filter::kIntegral1,
                                                texmap::Filter::kIntegral2, texmap::Filter::kIntegral3}) {
              texmap::TileCache cache(texmap::kDefaultTextureMemory);
              const texmap::TextureSampler sampler({image, texmap::Wrap::kRepeat}, filter, cache, 0);
              texmap::FilterThread thread(cache);
              // Each of the boxes that are convolved is of whole repeats, so the mean is all that is left.
              const double order =
                  1 + static_cast<int>(filter) - static_cast<int>(texmap::Filter::kIntegral1);
              const glm::dvec2 corner(0.25, 0.75);
              const glm::vec3 value = texmap::reads_table(filter)
                                          ? sampler.over_box({corner, corner + order * repeats}, thread)
                                          : sampler.sample({corner, {repeats, 0}, {0, repeats}}, thread);
              worst = worse(worst, std::abs(static_cast<double>(value.x) - mean) / kLevel);
            }
            // Six levels of a pyramid, each rounded to 16 bits by half a step.
            return Reached{.error = worst, .bound = 1e-3 + 6 * 0.5 / 65535 / kLevel};
          }};
}

StabilityCase far_repeats(double repeats, const std::string& power) {
  return {.name = "footprints_repeat_" + power,
          .stage = kStage,
          .input = "(u,v) moved by " + power + " whole repeats, every filter",
          .hardness = repeats,
          .hardness_is = "repeats",
          .promise = kWraps,
          .unit = "8-bit levels of difference",
          .run = [repeats] {
            const double worst = over_filters([&](const auto&, texmap::Filter, const auto& sample) {
              double most = 0;
              for (int n = 0; n < 16; ++n) {
                // Sixteenths of texels: sums with 2^40 repeats are exact.
                const glm::dvec2 uv((137 * n % 1024) / 1024.0, (731 * n % 1024) / 1024.0);
                const glm::dvec2 dx(3.0 / kSide, 0.5 / kSide);
                const glm::dvec2 dy(-0.25 / kSide, 2.0 / kSide);
                most = worse(most, std::abs(sample({uv, dx, dy}) - sample({uv + repeats, dx, dy})) / kLevel);
              }
              return most;
            });
            // Filters take several places of a footprint, each rounded where it is, against a slope of the
            // whole range (1/2) a texel; and the result's own step.
            return Reached{.error = worst, .bound = (0.5 * kSide * repeats * kRounding + 0x1p-24) / kLevel};
          }};
}

StabilityCase not_finite() {
  StabilityCase one = in_range("not_finite", "steps that are infinite, as seen right from the edge", 1e308,
                               "texels across the pixel, at least", {INFINITY, 0}, {0, INFINITY});
  return one;
}

// A triangle seen under a slope: the derivatives' footprint keeps to the plane that it falls on.
StabilityCase edge_on(double slope, const std::string& power) {
  return {.name = "footprints_edge_on_" + power,
          .stage = kStage,
          .input = "a triangle whose height is " + power + " m over 1 m: footprint by derivatives",
          .hardness = 1 / slope,
          .hardness_is = "length over height",
          .promise = "the footprint is backward stable as the triangle map is",
          .unit = "relative",
          .run = [slope] {
            // Right-angled in the model too: dv is exactly 1 / slope a metre of height.
            const texmap::Triangle3<double> t{{0, slope, 0}, {0, 0, 0}, {1, 0, 0}};
            const texmap::Footprint footprint =
                texmap::footprint_from(t, {glm::dvec2(0, 1), glm::dvec2(0, 0), glm::dvec2(1, 0)},
                                       {0.25, 0.25}, {1e-3, 0, 0}, {0, 1e-3, 0});
            const double error =
                worse(std::abs(footprint.dy.y * slope / 1e-3 - 1), std::abs(footprint.dx.x / 1e-3 - 1));
            return Reached{.error = error, .bound = 16 * kRounding};
          }};
}

}  // namespace

std::vector<StabilityCase> footprint_cases() {
  const double texel = 1.0 / kSide;
  return {
      in_range("size_0", "a footprint of no size", 1e300, "texels over the pixel, at least", {0, 0}, {0, 0}),
      in_range("aspect_1e3", "a footprint 1000 times as long as wide", 1e3, "length over width",
               {10 * texel, 0}, {0, 0.01 * texel}),
      in_range("aspect_1e9", "a footprint 1e9 times as long as wide, across", 1e9, "length over width",
               {1, 1}, {-1e-9, 1e-9}),
      in_range("long_1e6", "a footprint 1e6 repeats long, one texel wide", 1e6 * kSide, "length over width",
               {1e6, 0}, {0, texel}),
      not_finite(),
      whole_texture(1, "1"),
      whole_texture(64, "64"),
      far_repeats(0x1p20, "2e20"),
      far_repeats(0x1p40, "2e40"),
      edge_on(1e-6, "1e_6"),
      edge_on(1e-60, "1e_60")};
}

}  // namespace sweepkit::report
