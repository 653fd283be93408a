// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Heckbert89]: a round filter on the screen is an ellipse on the texture, J V J^T its covariance,
// where J takes a step of a pixel to texels and V is the filter's covariance on the screen. Departs from it
//   - in the filter: (1 - q)^2 for q < 1, q = 1 on the ellipse's rim, in place of a Gaussian from a table. It
//   is
//     as smooth where it ends, needs no table, and its width is set by its variance, which is that of the
//     project's pixel filter, a tent of one pixel each way: 1/6 of a pixel squared;
//   - in the level: the coarsest at which the minor axis is still kLeastSigma texels wide, so that a lookup
//     reads some 20 texels a unit of aspect, far off as well as near (Heckbert reads the finest);
//   - in its ends: neither axis is ever less than kLeastSigma texels, which is about what bilinear
//     interpolation is, so no footprint falls between the texels; ellipses longer than kLongest are made
//     rounder, and ones larger than a few textures smaller.
//
// Symbols, in texels of a level: (a c; c b) is the covariance times kRim, so that q = d^T (a c; c b)^-1 d. In
// the row dy below the middle q is least, dy^2 / b, at dx = c / b dy, and grows from there by (dx)^2 / (a -
// c^2 / b).

#include "elliptical_average.hpp"

#include <algorithm>
#include <cmath>

#include "mip_filter.hpp"

namespace sweepkit::texmap {
namespace {

constexpr double kPixelVariance = 1.0 / 6;
constexpr double kRim = 8;  // (1 - q)^2 has a variance of 1/8 of the squared radius along each axis
constexpr double kLeastSigma = 0.5;
constexpr double kLongest = 64;
constexpr double kMostTextures = 4;  // an ellipse's radius along u or v

struct Covariance {
  double a = 0;  // of x
  double b = 0;  // of y
  double c = 0;  // of both

  double half_difference() const { return std::hypot(0.5 * (a - b), c); }
  double major() const { return 0.5 * (a + b) + half_difference(); }
};

// The covariance of a footprint, in texels of the finest level, with axes that can be worked with, and the
// variance along its minor axis.
struct Ellipse {
  Covariance covariance;
  double minor = 0;
};

Ellipse ellipse_of(glm::dvec2 dx, glm::dvec2 dy, glm::dvec2 size) {
  // Radii beyond a few textures change nothing where the texture repeats, and little where it does not.
  const double reach_x = std::sqrt(kRim * kPixelVariance) * std::hypot(dx.x, dy.x) / (kMostTextures * size.x);
  const double reach_y = std::sqrt(kRim * kPixelVariance) * std::hypot(dx.y, dy.y) / (kMostTextures * size.y);
  const double excess = std::max(reach_x, reach_y);
  if (excess > 1) {
    dx /= excess;
    dy /= excess;
  }
  Covariance m{kPixelVariance * (dx.x * dx.x + dy.x * dy.x), kPixelVariance * (dx.y * dx.y + dy.y * dy.y),
               kPixelVariance * (dx.x * dx.y + dy.x * dy.y)};
  const double major = m.major();
  const double area = kPixelVariance * (dx.x * dy.y - dx.y * dy.x);
  // From the steps themselves: the difference of the covariance's near eigenvalues would lose a thin
  // ellipse's.
  const double minor = major > 0 ? area * area / major : 0;
  constexpr double kLeast = kLeastSigma * kLeastSigma;
  const double least = std::max(kLeast, major / (kLongest * kLongest));
  if (major <= kLeast) return {{kLeast, kLeast, 0}, kLeast};
  if (minor >= least) return {m, minor};
  // To the minor axis alone: its projection is (major I - m) / (major - minor).
  const double half_difference = m.half_difference();
  if (half_difference > 0) {
    const double share = (least - minor) / (2 * half_difference);
    const double half = 0.5 * (m.a - m.b);
    m = {m.a + share * (half_difference - half), m.b + share * (half_difference + half), m.c * (1 - share)};
  }
  return {m, least};
}

// The sum of the texels under the ellipse, weighed, and with it the sum of the weights.
template <class Texel>
Float4 weighed_sum(const Pyramid& pyramid, int level, Wrap wrap, const Covariance& rim, glm::dvec2 middle,
                   FilterScratch& scratch) {
  const Pyramid::Level& size = pyramid.level(level);
  const double slope = rim.c / rim.b;
  const double across = rim.a - slope * rim.c;  // the squared half width of the row through the middle
  const double half_height = std::sqrt(rim.b);
  const double half_width = std::sqrt(rim.a);
  // Texel i has its middle at i + 1/2.
  middle -= 0.5;
  const int first_row = static_cast<int>(std::ceil(middle.y - half_height));
  const int last_row = static_cast<int>(std::floor(middle.y + half_height));
  scratch.spans.clear();
  for (int y = first_row; y <= last_row; ++y) {
    const double dy = y - middle.y;
    const double top = std::max(0.0, 1 - dy * dy / rim.b);
    const double x = middle.x + slope * dy;
    const double half = std::sqrt(top * across);
    scratch.spans.push_back(
        {static_cast<int>(std::ceil(x - half)), static_cast<int>(std::floor(x + half)), top, x});
  }
  cut_into_runs(first_row, last_row, size.height, wrap, scratch.rows);
  cut_into_runs(static_cast<int>(std::ceil(middle.x - half_width)),
                static_cast<int>(std::floor(middle.x + half_width)), size.width, wrap, scratch.columns);
  const auto steepness = static_cast<float>(1 / across);
  Float4 sum = {};
  for (const AxisRun& rows : scratch.rows) {
    for (const AxisRun& columns : scratch.columns) {
      const Texel* tile = pyramid.tile<Texel>(scratch.tiles, level, columns.tile, rows.tile);
      for (int k = 0; k < rows.count; ++k) {
        const Span& span = scratch.spans[static_cast<std::size_t>(rows.first + k - first_row)];
        const int first = std::max(span.first, columns.first);
        const int last = std::min(span.last, columns.first + columns.count - 1);
        const Texel* texel = tile + (rows.offset + k * rows.step) * kTileSide + columns.offset +
                             (first - columns.first) * columns.step;
        auto dx = static_cast<float>(first - span.middle);
        const auto top = static_cast<float>(span.top);
        for (int x = first; x <= last; ++x, dx += 1, texel += columns.step) {
          const float t = top - steepness * dx * dx;
          sum += t * t * to_float4(*texel);
        }
      }
    }
  }
  return sum;
}

}  // namespace

glm::vec3 elliptical_average(const Pyramid& pyramid, Wrap wrap, const Footprint& footprint,
                             FilterScratch& scratch) {
  const Pyramid::Level& finest = pyramid.level(0);
  const glm::dvec2 size(finest.width, finest.height);
  const glm::dvec2 steps = (glm::abs(footprint.dx) + glm::abs(footprint.dy)) * size;
  const glm::dvec2 uv = footprint.uv;
  const bool is_finite = std::isfinite(steps.x + steps.y) && std::isfinite(uv.x + uv.y);
  if (!is_finite) return mean_of_all(pyramid, scratch.tiles);
  // v runs upwards, rows run down: the ellipse is mirrored with them.
  const Ellipse ellipse = ellipse_of(footprint.dx * glm::dvec2(size.x, -size.y),
                                     footprint.dy * glm::dvec2(size.x, -size.y), size);
  const auto scale_of = [&](int level) {
    return glm::dvec2(pyramid.level(level).width, pyramid.level(level).height) / size;
  };
  int level = 0;
  while (level + 1 < pyramid.level_count()) {
    const glm::dvec2 next = scale_of(level + 1);
    const double least = std::min(next.x, next.y);
    if (ellipse.minor * least * least < kLeastSigma * kLeastSigma) break;
    ++level;
  }
  const glm::dvec2 scale = scale_of(level);
  const Covariance& m = ellipse.covariance;
  const Covariance rim{kRim * m.a * scale.x * scale.x, kRim * m.b * scale.y * scale.y,
                       kRim * m.c * scale.x * scale.y};
  const glm::dvec2 middle = near_origin(glm::dvec2(uv.x, 1 - uv.y), wrap) * scale * size;
  const Float4 sum = pyramid.is_float()
                         ? weighed_sum<FloatTexel>(pyramid, level, wrap, rim, middle, scratch)
                         : weighed_sum<IntegerTexel>(pyramid, level, wrap, rim, middle, scratch);
  return glm::vec3(sum[0], sum[1], sum[2]) / sum[3];
}

}  // namespace sweepkit::texmap
