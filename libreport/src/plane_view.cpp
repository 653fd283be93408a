// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "plane_view.hpp"

#include <algorithm>
#include <cstdint>
#include <random>

namespace sweepkit::report {
namespace {

constexpr int kReferenceSamples = 64;  // along each side of a tent

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

const double kPitchCos = std::cos(radians(-20));
const double kPitchSin = std::sin(radians(-20));
const double kHalf = std::tan(radians(30));
const double kLeastFall = std::tan(radians(1));

std::size_t texel_index(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

// A weighed mean, and apart those of its two halves.
struct HalvedMean {
  double sum[2] = {0, 0};
  double weight[2] = {0, 0};

  void add(int half, double by, double value) {
    sum[half] += by * value;
    weight[half] += by;
  }
  double mean() const { return (sum[0] + sum[1]) / (weight[0] + weight[1]); }
  double half_difference() const { return (sum[0] / weight[0] - sum[1] / weight[1]) / 2; }
};

}  // namespace

PlaneView::PlaneView(int side, double turn_deg)
    : side_(side), turn_cos_(std::cos(radians(turn_deg))), turn_sin_(std::sin(radians(turn_deg))) {}

std::optional<glm::dvec2> PlaneView::uv(const glm::dvec2& place) const {
  const double x = (2 * place.x / side_ - 1) * kHalf;
  const double y = (1 - 2 * place.y / side_) * kHalf;
  const double fall = -(y * kPitchCos + kPitchSin);
  const double ahead = kPitchCos - y * kPitchSin;
  if (fall < ahead * kLeastFall) return std::nullopt;
  const glm::dvec2 at = glm::dvec2(x, ahead) / fall;
  return 0.5 * glm::dvec2(turn_cos_ * at.x - turn_sin_ * at.y, turn_sin_ * at.x + turn_cos_ * at.y);
}

std::vector<PlanePixel> plane_pixels(const PlaneView& view) {
  std::vector<PlanePixel> pixels;
  for (int y = 0; y < view.side(); ++y) {
    for (int x = 0; x < view.side(); ++x) {
      const glm::dvec2 at(x + 0.5, y + 0.5);
      if (!view.uv(at - glm::dvec2(0, 1.5))) continue;
      const auto difference = [&](const glm::dvec2& step) {
        return *view.uv(at + 0.5 * step) - *view.uv(at - 0.5 * step);
      };
      pixels.push_back({x, y, {*view.uv(at), difference({1, 0}), difference({0, 1})}});
    }
  }
  return pixels;
}

PlaneTexture checker_texture(int side) {
  PlaneTexture texture{side, {}};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) texture.texels.push_back((x / 32 + y / 32) % 2 != 0 ? 0.9f : 0.05f);
  }
  return texture;
}

PlaneTexture noise_texture(int side) {
  std::vector<double> sum(texel_index(0, side, side), 0.0);
  std::mt19937 random(7);
  for (int cells = 4; cells <= side; cells *= 2) {
    std::vector<double> lattice(texel_index(0, cells, cells));
    for (double& value : lattice) value = std::uniform_real_distribution<>(-1, 1)(random);
    const auto at = [&](int x, int y) { return lattice[texel_index(x % cells, y % cells, cells)]; };
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const double gx = (x + 0.5) * cells / side;
        const double gy = (y + 0.5) * cells / side;
        const int ix = static_cast<int>(gx);
        const int iy = static_cast<int>(gy);
        const double fx = gx - ix;
        const double fy = gy - iy;
        sum[texel_index(x, y, side)] += std::lerp(std::lerp(at(ix, iy), at(ix + 1, iy), fx),
                                                  std::lerp(at(ix, iy + 1), at(ix + 1, iy + 1), fx), fy);
      }
    }
  }
  PlaneTexture texture{side, {}};
  for (const double value : sum)
    texture.texels.push_back(static_cast<float>(std::clamp(0.5 + 0.16 * value, 0.0, 1.0)));
  return texture;
}

std::shared_ptr<const texmap::Image> to_image(const PlaneTexture& texture) {
  std::vector<std::uint16_t> samples;
  for (const float value : texture.texels) {
    for (int k = 0; k < 3; ++k) samples.push_back(static_cast<std::uint16_t>(std::lround(65535 * value)));
  }
  return std::make_shared<const texmap::Image>(texmap::Image{texture.side, texture.side, 3, samples});
}

PlaneReference plane_reference(const PlaneView& view, const PlaneTexture& texture,
                               const std::vector<PlanePixel>& pixels) {
  const auto texel_of = [side = texture.side](double turns) {
    return std::min(static_cast<int>((turns - std::floor(turns)) * side), side - 1);
  };
  PlaneReference reference;
  double tent_squares = 0;
  double box_squares = 0;
  for (const PlanePixel& pixel : pixels) {
    HalvedMean tent;
    HalvedMean box;
    for (int j = 0; j < kReferenceSamples; ++j) {
      for (int i = 0; i < kReferenceSamples; ++i) {
        const glm::dvec2 offset = (glm::dvec2(i, j) + 0.5) / (0.5 * kReferenceSamples) - 1.0;
        const glm::dvec2 uv = *view.uv(glm::dvec2(pixel.x + 0.5, pixel.y + 0.5) + offset);
        const auto value = static_cast<double>(
            texture.texels[texel_index(texel_of(uv.x), texel_of(1 - uv.y), texture.side)]);
        const int half = (i + j) % 2;
        tent.add(half, (1 - std::abs(offset.x)) * (1 - std::abs(offset.y)), value);
        if (std::abs(offset.x) < 0.5 && std::abs(offset.y) < 0.5) box.add(half, 1, value);
      }
    }
    reference.tent.push_back(tent.mean());
    reference.box.push_back(box.mean());
    tent_squares += tent.half_difference() * tent.half_difference();
    box_squares += box.half_difference() * box.half_difference();
  }
  const auto count = static_cast<double>(pixels.size());
  reference.tent_error = std::sqrt(tent_squares / count);
  reference.box_error = std::sqrt(box_squares / count);
  return reference;
}

}  // namespace sweepkit::report
