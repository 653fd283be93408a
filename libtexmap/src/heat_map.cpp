// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Colours are laid out in OKLab [Ottosson 2020, A perceptual color space for image processing], in which
// equal steps of L look equally far apart; lightness alone tells the value, so that the map reads in grey,
// too.

#include "sweepkit/texmap/heat_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "sweepkit/error.hpp"
#include "uv_raster.hpp"

namespace sweepkit::texmap {
namespace {

constexpr double kFarthestUv = 1 << 20;
constexpr double kLeastBrightest = 1.1;

struct UvBox {
  glm::dvec2 low{0.0};
  glm::dvec2 high{1.0};
};

// The whole squares of the texture that the mapping touches.
UvBox whole_squares(const MappedSurface& surface) {
  UvBox box{glm::dvec2(kFarthestUv), glm::dvec2(-kFarthestUv)};
  for (const auto& triangle : surface.triangles) {
    for (const std::uint32_t vertex : triangle) {
      const glm::dvec2 uv(surface.texcoords[vertex]);
      if (!(std::abs(uv.x) <= kFarthestUv && std::abs(uv.y) <= kFarthestUv)) {
        throw InputError("a heat map needs (u,v) within 1048576 of 0, got (" + std::to_string(uv.x) + ", " +
                         std::to_string(uv.y) + ")");
      }
      box.low = glm::min(box.low, uv);
      box.high = glm::max(box.high, uv);
    }
  }
  if (surface.triangles.empty()) return {};
  box.low = glm::floor(box.low);
  box.high = glm::max(glm::ceil(box.high), box.low + 1.0);
  return box;
}

double percentile_99(std::span<const TriangleDistortion> triangles, std::span<const double> ratios) {
  struct Weighted {
    double ratio, area;
  };
  std::vector<Weighted> all;
  double area = 0;
  for (std::size_t t = 0; t < ratios.size(); ++t) {
    if (!std::isfinite(ratios[t])) continue;
    all.push_back({ratios[t], triangles[t].area});
    area += triangles[t].area;
  }
  std::sort(all.begin(), all.end(), [](const Weighted& a, const Weighted& b) { return a.ratio < b.ratio; });
  double below = 0;
  for (const Weighted& w : all) {
    below += w.area;
    if (below >= 0.99 * area) return w.ratio;
  }
  return 1;
}

// Ratios by texel, 0 where no triangle lies.
using Texels = std::vector<float>;

// Every empty texel takes the ratio of the nearest one that is not, as far as two passes find it: each hands
// on from the neighbours before it how far away the source is, first from above and left, then from below
// and right [Rosenfeld & Pfaltz 1966, Sequential operations in digital picture processing].
void fill_empty(Texels& texels, int width, int height) {
  std::vector<int> distance(texels.size());
  for (std::size_t i = 0; i < texels.size(); ++i) distance[i] = texels[i] > 0 ? 0 : width + height;
  const auto pass = [&](int step) {
    const int count = width * height;
    for (int k = 0; k < count; ++k) {
      const int i = step > 0 ? k : count - 1 - k;
      const int x = i % width;
      for (const int from : {x - step >= 0 && x - step < width ? i - step : -1, i - step * width}) {
        if (from < 0 || from >= count) continue;
        const auto near = static_cast<std::size_t>(from);
        const auto here = static_cast<std::size_t>(i);
        if (distance[near] + 1 >= distance[here]) continue;
        distance[here] = distance[near] + 1;
        texels[here] = texels[near];
      }
    }
  };
  pass(1);
  pass(-1);
}

}  // namespace

glm::vec3 heat_color(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  const double lightness = 0.25 + 0.7 * t;
  // As much colour as stays inside sRGB all along.
  const double chroma = 0.12 - 0.03 * t + 0.24 * t * (1 - t);
  const double hue = (285 + 180 * t) * std::numbers::pi / 180;
  const double a = chroma * std::cos(hue);
  const double b = chroma * std::sin(hue);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  const glm::dvec3 rgb(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                       -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                       -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s);
  return glm::vec3(glm::clamp(rgb, glm::dvec3(0.0), glm::dvec3(1.0)));
}

HeatMap draw_heat_map(const MappedSurface& surface, std::span<const double> ratios,
                      const HeatMapOptions& options) {
  constexpr int kMostTexels = 32768;
  const auto& [width, height] = options;
  if (width < 1 || height < 1 || width > kMostTexels || height > kMostTexels) {
    throw InputError("a heat map needs 1 to 32768 texels a side, got " + std::to_string(width) + " x " +
                     std::to_string(height));
  }
  const UvBox box = whole_squares(surface);
  Texels texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f);
  const glm::dvec2 size(width, height);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    std::array<glm::dvec2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 uv(surface.texcoords[surface.triangles[t][k]]);
      const glm::dvec2 at = (uv - box.low) / (box.high - box.low);
      p[k] = glm::dvec2(at.x, 1 - at.y) * size;
    }
    const auto ratio = static_cast<float>(ratios[t]);
    for_each_texel(p, options.width, options.height, [&](int x, int y) {
      float& texel = texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(options.width) +
                            static_cast<std::size_t>(x)];
      texel = std::max(texel, ratio);
    });
  }
  fill_empty(texels, width, height);

  HeatMap map{.low = box.low, .high = box.high};
  map.brightest = std::max(percentile_99(find_distortion(surface), ratios), kLeastBrightest);
  std::vector<std::uint16_t> samples;
  samples.reserve(3 * texels.size());
  for (const float ratio : texels) {
    const double share = ratio > 0 ? std::log(static_cast<double>(ratio)) / std::log(map.brightest) : 0;
    const glm::vec3 color = heat_color(share);
    for (glm::length_t k = 0; k < 3; ++k)
      samples.push_back(static_cast<std::uint16_t>(std::lround(65535.0f * color[k])));
  }
  map.image = {width, height, 3, std::move(samples)};
  return map;
}

}  // namespace sweepkit::texmap
