// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Tables of integrals against sums of the texels themselves, with whole weights, in quadruple precision.
// float32 beside ours: a table of order 1 whose entries are float32, as [Crow84] would have it today.

#include <memory>
#include <random>

#include "quad.hpp"
#include "stability/integral_weights.hpp"
#include "stability/stability_case.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kStage = "tables";
constexpr const char* kExact = "table filters: boxes with integer corners exact for 8- and 16-bit textures";
constexpr const char* kConstant = "table filters: a constant texture comes back constant";
constexpr const char* kFloats = "table filters: float textures within 0.01 of an 8-bit level";
constexpr double kLevel = 1.0 / 255;

texmap::Filter filter_of(int order) {
  return static_cast<texmap::Filter>(static_cast<int>(texmap::Filter::kIntegral1) + order - 1);
}

texmap::Image noise(int width, int height) {
  texmap::Image image{width, height, 1, std::vector<std::uint16_t>()};
  auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
  std::mt19937 random(1);
  for (int i = 0; i < width * height; ++i) texels.push_back(static_cast<std::uint16_t>(random() & 0xFFFFu));
  return image;
}

texmap::Image float_noise(int width, int height, double range) {
  texmap::Image image{width, height, 1, std::vector<float>()};
  auto& texels = std::get<std::vector<float>>(image.texels);
  std::mt19937 random(1);
  // From 1 / range to 1, every power of ten alike.
  for (int i = 0; i < width * height; ++i)
    texels.push_back(static_cast<float>(std::pow(range, -static_cast<double>(random()) / 4294967296.0)));
  return image;
}

double texel_of(const texmap::Image& image, int x, int y) {
  const auto index =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
  return image.is_float() ? static_cast<double>(std::get<std::vector<float>>(image.texels)[index])
                          : std::get<std::vector<std::uint16_t>>(image.texels)[index] / 65535.0;
}

struct Box {
  int x, y, width, height;  ///< of one of the boxes that are convolved
};

Quad exact_over(const texmap::Image& image, const Box& box, int order) {
  const std::vector<double> across = box_weights(order, box.width);
  const std::vector<double> down = box_weights(order, box.height);
  Quad sum = 0;
  Quad weight = 0;
  const bool is_float = image.is_float();
  for (std::size_t j = 0; j < down.size(); ++j) {
    for (std::size_t i = 0; i < across.size(); ++i) {
      const int x = (box.x + static_cast<int>(i)) % image.width;
      const int y = (box.y + static_cast<int>(j)) % image.height;
      const Quad w = static_cast<Quad>(across[i]) * down[j];
      const auto index =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
      sum += w * (is_float ? static_cast<Quad>(texel_of(image, x, y))
                           : static_cast<Quad>(std::get<std::vector<std::uint16_t>>(image.texels)[index]));
      weight += w;
    }
  }
  return sum / weight / (is_float ? 1 : 65535);
}

texmap::UvBox uv_of(const texmap::Image& image, const Box& box, int order) {
  const glm::dvec2 size(image.width, image.height);
  return {{box.x / size.x, 1 - (box.y + order * box.height) / size.y},
          {(box.x + order * box.width) / size.x, 1 - box.y / size.y}};
}

std::vector<Box> boxes(const texmap::Image& image) {
  std::mt19937 random(3);
  std::vector<Box> all;
  for (int n = 0; n < 100; ++n) {
    const int x = static_cast<int>(random() % static_cast<unsigned>(image.width));
    const int y = static_cast<int>(random() % static_cast<unsigned>(image.height));
    const int width = 1 + static_cast<int>(random() % 8);
    all.push_back({x, y, width, 1 + static_cast<int>(random() % 8)});
  }
  // At the far corner, where the entries are largest.
  all.push_back({image.width - 8, image.height - 8, 2, 2});
  return all;
}

// The same boxes from a table of float32 sums, order 1.
double by_float_table(const texmap::Image& image) {
  const auto width = static_cast<std::size_t>(image.width) + 1;
  std::vector<float> table(width * (static_cast<std::size_t>(image.height) + 1), 0.0F);
  for (int y = 0; y < image.height; ++y) {
    float row = 0;
    for (int x = 0; x < image.width; ++x) {
      row += static_cast<float>(texel_of(image, x, y));
      const std::size_t at = (static_cast<std::size_t>(y) + 1) * width + static_cast<std::size_t>(x) + 1;
      table[at] = table[at - width] + row;
    }
  }
  double worst = 0;
  for (const Box& box : boxes(image)) {
    if (box.x + box.width > image.width || box.y + box.height > image.height) continue;
    const auto entry = [&](int x, int y) {
      return table[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
    };
    const float sum = entry(box.x + box.width, box.y + box.height) - entry(box.x, box.y + box.height) -
                      entry(box.x + box.width, box.y) + entry(box.x, box.y);
    const double mean = static_cast<double>(sum) / (box.width * box.height);
    worst = worse(worst, static_cast<double>(fabsq(mean - exact_over(image, box, 1))));
  }
  return worst / kLevel;
}

double by_tables(const texmap::Image& image, int order) {
  texmap::TileCache cache(std::size_t{256} << 20);
  const texmap::TextureSampler sampler({std::make_shared<const texmap::Image>(image), texmap::Wrap::kRepeat},
                                       filter_of(order), cache, 0);
  texmap::FilterThread thread(cache);
  double worst = 0;
  for (const Box& box : boxes(image)) {
    const double mean = static_cast<double>(sampler.over_box(uv_of(image, box, order), thread).x);
    worst = worse(worst, static_cast<double>(fabsq(mean - exact_over(image, box, order))));
  }
  return worst / kLevel;
}

// The largest entry of a table of this order over white.
double largest_entry(int width, int height, int order) {
  double entry = 65535;
  for (int k = 0; k < order; ++k) entry *= (width + k) / (k + 1.0) * ((height + k) / (k + 1.0));
  return entry;
}

StabilityCase whole_boxes(int width, int height, int order) {
  const std::string size = std::to_string(width) + "_" + std::to_string(height);
  return {.name = "tables_boxes_" + std::to_string(order) + "_" + size,
          .stage = kStage,
          .input = std::to_string(width) + " x " + std::to_string(height) + " texels of 16 bits, order " +
                   std::to_string(order) + ", boxes with integer corners",
          .hardness = largest_entry(width, height, order),
          .hardness_is = "largest entry of a table over white; words wrap round at 1.8e19",
          .promise = kExact,
          .unit = "8-bit levels",
          .run = [=] {
            const texmap::Image image = noise(width, height);
            // The float that is nearest: half a step below 1.
            Reached reached{.error = by_tables(image, order), .bound = 0x1p-25 / kLevel};
            if (order == 1) reached.in_float = by_float_table(image);
            return reached;
          }};
}

StabilityCase constant(int order, bool is_float) {
  return {.name = "tables_constant_" + std::to_string(order) + (is_float ? "_float" : "_integer"),
          .stage = kStage,
          .input = std::string("constant ") + (is_float ? "float" : "16-bit") +
                   " texture of 512 x 512, order " + std::to_string(order) + ", any box",
          .hardness = largest_entry(512, 512, order),
          .hardness_is = "largest entry of a table over white; words wrap round at 1.8e19",
          .promise = kConstant,
          .unit = "8-bit levels",
          .run = [=] {
            texmap::Image image{512, 512, 1, std::vector<std::uint16_t>(512 * 512, 40001)};
            if (is_float) image.texels = std::vector<float>(512 * 512, 0.3F);
            const float value = is_float ? 0.3F : static_cast<float>(40001 / 65535.0);
            texmap::TileCache cache(texmap::kDefaultTextureMemory);
            const texmap::TextureSampler sampler(
                {std::make_shared<const texmap::Image>(std::move(image)), texmap::Wrap::kRepeat},
                filter_of(order), cache, 0);
            texmap::FilterThread thread(cache);
            std::mt19937 random(2);
            std::uniform_real_distribution<double> real(0, 1);
            Reached reached;
            for (int n = 0; n < 500; ++n) {
              const glm::dvec2 corner(10 * real(random) - 5, 10 * real(random) - 5);
              const double wide = std::exp2(-12 * real(random));
              const double mean =
                  static_cast<double>(sampler.over_box({corner, corner + glm::dvec2(wide, 0.01)}, thread).x);
              reached.error = worse(reached.error, std::abs(mean - static_cast<double>(value)) / kLevel);
            }
            return reached;
          }};
}

StabilityCase float_range(double range, const std::string& power, int order) {
  return {.name = "tables_float_" + std::to_string(order) + "_" + power,
          .stage = kStage,
          .input = "float texture of 256 x 256 with values from 1/" + power + " to 1, order " +
                   std::to_string(order),
          .hardness = range,
          .hardness_is = "largest over smallest texel",
          .promise = kFloats,
          .unit = "8-bit levels",
          .run = [=] {
            const texmap::Image image = float_noise(256, 256, range);
            Reached reached{.error = by_tables(image, order), .bound = 0.01};
            if (order == 1) reached.in_float = by_float_table(image);
            return reached;
          }};
}

}  // namespace

std::vector<StabilityCase> table_cases() {
  return {whole_boxes(512, 512, 1),   whole_boxes(512, 512, 2),   whole_boxes(512, 512, 3),
          whole_boxes(16384, 16, 1),  whole_boxes(16384, 16, 3),  whole_boxes(16, 16384, 3),
          constant(1, false),         constant(3, false),         constant(1, true),
          constant(3, true),          float_range(1e3, "1e3", 1), float_range(1e9, "1e9", 1),
          float_range(1e3, "1e3", 3), float_range(1e9, "1e9", 3)};
}

}  // namespace sweepkit::report
