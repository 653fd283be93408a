// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: a difference evaluator
// for alternating images", HPG 2020; the constants are that paper's. Two pipelines a pixel: colour (opponent
// space, filtered by the eye's contrast sensitivity, Hunt-adjusted Lab, HyAB distance) and features (edges
// and points of the luminance). The kernels are sums of Gaussians and their derivatives, so each is applied
// along x, then along y.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "checked_rect.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::texmap {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kColorExponent = 0.7;    // q_c
constexpr double kSmallErrorShare = 0.4;  // p_c
constexpr double kSmallErrorTop = 0.95;   // p_t
constexpr double kFeatureWidthDegrees = 0.082;
constexpr double kFeatureExponent = 0.5;                 // q_f
const glm::dvec3 kWhite(0.950428545, 1.0, 1.088900371);  // XYZ of linear RGB (1, 1, 1)

// A picture as planes of doubles.
struct Plane {
  int width, height;
  std::vector<double> values;

  double& at(int x, int y) {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  double at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

Plane make_plane(int width, int height) {
  return {width, height,
          std::vector<double>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
}

glm::dvec3 xyz_from_linear(const glm::dvec3& c) {
  return {0.4124564 * c.r + 0.3575761 * c.g + 0.1804375 * c.b,
          0.2126729 * c.r + 0.7151522 * c.g + 0.0721750 * c.b,
          0.0193339 * c.r + 0.1191920 * c.g + 0.9503041 * c.b};
}

glm::dvec3 linear_from_xyz(const glm::dvec3& c) {
  return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z,
          -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
          0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

glm::dvec3 opponent_from_linear(const glm::dvec3& color) {
  const glm::dvec3 c = xyz_from_linear(color) / kWhite;
  return {116 * c.y - 16, 500 * (c.x - c.y), 200 * (c.y - c.z)};
}

glm::dvec3 linear_from_opponent(const glm::dvec3& c) {
  const double y = (c.x + 16) / 116;
  return linear_from_xyz(glm::dvec3(y + c.y / 500, y, y - c.z / 200) * kWhite);
}

glm::dvec3 hunt_lab_from_linear(const glm::dvec3& color) {
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const glm::dvec3 c = xyz_from_linear(color) / kWhite;
  const double lightness = 116 * f(c.y) - 16;
  return {lightness, 0.01 * lightness * 500 * (f(c.x) - f(c.y)), 0.01 * lightness * 200 * (f(c.y) - f(c.z))};
}

double hyab(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

std::vector<double> sampled(int radius, auto&& function) {
  std::vector<double> kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(function(static_cast<double>(i)));
  return kernel;
}

Plane convolve(const Plane& in, const std::vector<double>& along_x, const std::vector<double>& along_y) {
  const int radius = static_cast<int>(along_x.size() / 2);
  Plane middle = make_plane(in.width, in.height);
  for (int y = 0; y < in.height; ++y) {
    for (int x = 0; x < in.width; ++x) {
      double sum = 0;
      for (int k = 0; k <= 2 * radius; ++k) {
        sum += along_x[k] * in.at(std::clamp(x + k - radius, 0, in.width - 1), y);
      }
      middle.at(x, y) = sum;
    }
  }
  Plane out = make_plane(in.width, in.height);
  for (int y = 0; y < in.height; ++y) {
    for (int x = 0; x < in.width; ++x) {
      double sum = 0;
      for (int k = 0; k <= 2 * radius; ++k) {
        sum += along_y[k] * middle.at(x, std::clamp(y + k - radius, 0, in.height - 1));
      }
      out.at(x, y) = sum;
    }
  }
  return out;
}

struct Gaussians {
  double a1, b1, a2, b2;
};
// Contrast sensitivity of the achromatic, red-green and blue-yellow channels.
constexpr std::array<Gaussians, 3> kSensitivity = {
    {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};

Plane filter_by_sensitivity(const Plane& in, const Gaussians& g, double pixels_per_degree) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * pixels_per_degree));
  const auto gaussian = [&](double b) {
    return sampled(radius,
                   [&](double i) { return std::exp(-kPi * kPi * std::pow(i / pixels_per_degree, 2) / b); });
  };
  const auto sum = [](const std::vector<double>& kernel) {
    double total = 0;
    for (const double value : kernel) total += value;
    return total;
  };
  const std::vector<double> first = gaussian(g.b1);
  const std::vector<double> second = gaussian(g.b2);
  const double first_weight = g.a1 * std::sqrt(kPi / g.b1);
  const double second_weight = g.a2 * std::sqrt(kPi / g.b2);
  const double whole = first_weight * std::pow(sum(first), 2) + second_weight * std::pow(sum(second), 2);
  Plane out = convolve(in, first, first);
  for (double& value : out.values) value *= first_weight / whole;
  if (second_weight == 0) return out;
  const Plane added = convolve(in, second, second);
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] += second_weight / whole * added.values[i];
  return out;
}

std::array<Plane, 3> opponent_planes(const Image& image, const PixelRect& area) {
  std::array<Plane, 3> planes = {make_plane(area.width, area.height), make_plane(area.width, area.height),
                                 make_plane(area.width, area.height)};
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      const glm::dvec3 color = glm::clamp(glm::dvec3(image.color(area.x + x, area.y + y)), 0.0, 1.0);
      const glm::dvec3 opponent = opponent_from_linear(color);
      for (std::size_t k = 0; k < 3; ++k) planes[k].at(x, y) = opponent[static_cast<glm::length_t>(k)];
    }
  }
  return planes;
}

std::vector<glm::dvec3> seen_colors(const std::array<Plane, 3>& opponent, double pixels_per_degree) {
  std::array<Plane, 3> filtered;
  for (std::size_t k = 0; k < 3; ++k)
    filtered[k] = filter_by_sensitivity(opponent[k], kSensitivity[k], pixels_per_degree);
  std::vector<glm::dvec3> colors;
  for (std::size_t i = 0; i < filtered[0].values.size(); ++i) {
    const glm::dvec3 c(filtered[0].values[i], filtered[1].values[i], filtered[2].values[i]);
    colors.push_back(hunt_lab_from_linear(glm::clamp(linear_from_opponent(c), 0.0, 1.0)));
  }
  return colors;
}

// Scales the positive weights to a sum of 1 and the negative ones to -1.
void balance(std::vector<double>& kernel) {
  double positive = 0;
  double negative = 0;
  for (const double value : kernel) (value > 0 ? positive : negative) += value;
  for (double& value : kernel) value /= value > 0 ? positive : -negative;
}

struct Features {
  std::vector<double> edges, points;
};

Features features(const Plane& opponent_y, double pixels_per_degree) {
  Plane luminance = opponent_y;
  for (double& value : luminance.values) value = (value + 16) / 116;
  const double deviation = 0.5 * kFeatureWidthDegrees * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto gaussian = [&](double i) { return std::exp(-i * i / (2 * deviation * deviation)); };
  std::vector<double> smooth = sampled(radius, gaussian);
  std::vector<double> edge = sampled(radius, [&](double i) { return -i * gaussian(i); });
  std::vector<double> point =
      sampled(radius, [&](double i) { return (i * i / (deviation * deviation) - 1) * gaussian(i); });
  double sum = 0;
  for (const double value : smooth) sum += value;
  for (double& value : smooth) value /= sum;
  balance(edge);
  balance(point);
  const auto magnitude = [&](const std::vector<double>& kernel) {
    const Plane across = convolve(luminance, kernel, smooth);
    const Plane down = convolve(luminance, smooth, kernel);
    std::vector<double> result;
    for (std::size_t i = 0; i < across.values.size(); ++i)
      result.push_back(std::hypot(across.values[i], down.values[i]));
    return result;
  };
  return {magnitude(edge), magnitude(point)};
}

}  // namespace

double mean_flip(const Image& image, const Image& reference, const FlipOptions& options,
                 const PixelRect& rect) {
  const PixelRect area = checked_rect(image, reference, rect);
  const std::array<Plane, 3> opponent = opponent_planes(image, area);
  const std::array<Plane, 3> reference_opponent = opponent_planes(reference, area);
  const std::vector<glm::dvec3> colors = seen_colors(opponent, options.pixels_per_degree);
  const std::vector<glm::dvec3> reference_colors = seen_colors(reference_opponent, options.pixels_per_degree);
  const Features shape = features(opponent[0], options.pixels_per_degree);
  const Features reference_shape = features(reference_opponent[0], options.pixels_per_degree);

  const double largest =
      std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), kColorExponent);
  const double knee = kSmallErrorShare * largest;
  double sum = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double raw = std::pow(hyab(colors[i], reference_colors[i]), kColorExponent);
    const double color = raw < knee ? kSmallErrorTop / knee * raw
                                    : kSmallErrorTop + (raw - knee) / (largest - knee) * (1 - kSmallErrorTop);
    const double feature = std::max(std::abs(shape.edges[i] - reference_shape.edges[i]),
                                    std::abs(shape.points[i] - reference_shape.points[i]));
    sum += std::pow(color, 1 - std::pow(feature / std::numbers::sqrt2, kFeatureExponent));
  }
  return sum / static_cast<double>(colors.size());
}

}  // namespace sweepkit::texmap
