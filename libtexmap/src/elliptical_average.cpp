// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Heckbert89]: a round filter on the screen is an ellipse on the texture, J V J^T its covariance,
// where J takes a step of a pixel to texels and V is the filter's covariance on the screen. Departs from it
//   - in the filter: (1 - q)^2 for q < 1, q = 1 on the ellipse's rim, in place of a Gaussian from a table. It
//     is as smooth where it ends, needs no table, and its width is set by its variance, which is that of the
//     project's pixel filter, a tent of one pixel each way: 1/6 of a pixel squared;
//   - in the level: the coarsest at which the variance along the minor axis is still kLeastVariance texels
//     squared, so that a lookup reads some 20 texels a unit of aspect, far off as well as near (Heckbert
//     reads the finest);
//   - in its ends: neither axis has ever less than that variance, which is about what bilinear interpolation
//     has, so no footprint falls between the texels; ellipses longer than kLongest are made rounder, and ones
//     larger than a few textures smaller.
// Most footprints lie in one tile as a whole, and are added up in one go (ellipse_rows.hpp); others tile by
// tile.
//
// Symbols, in texels of a level: (a c; c b) is the covariance times kRim, so that q = d^T (a c; c b)^-1 d. In
// the row dy below the middle q is least, dy^2 / b, at dx = c / b dy, and grows from there by (dx)^2 / (a -
// c^2 / b).

#include "elliptical_average.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "ellipse_rows.hpp"
#include "mip_filter.hpp"

namespace sweepkit::texmap {
namespace {

constexpr double kPixelVariance = 1.0 / 6;
constexpr double kRim = 8;  // (1 - q)^2 has a variance of 1/8 of the squared radius along each axis
constexpr double kLeastVariance = 0.25;
constexpr double kLongest = 64;
constexpr double kLongestBalanced = 32;
constexpr double kMostTextures = 4;  // an ellipse's radius along u or v

struct Covariance {
  double a = 0;  // of x
  double b = 0;  // of y
  double c = 0;  // of both
};

// The covariance of a footprint, in texels of the finest level, with axes that can be worked with, and the
// variances along them.
struct Ellipse {
  Covariance covariance;
  double major = 0;
  double minor = 0;
};

Ellipse ellipse_of(glm::dvec2 dx, glm::dvec2 dy, glm::dvec2 size, double longest) {
  // Radii beyond a few textures change nothing where the texture repeats, and little where it does not.
  const glm::dvec2 reach = std::sqrt(kRim * kPixelVariance) * (glm::abs(dx) + glm::abs(dy));
  const glm::dvec2 most = kMostTextures * size;
  if (reach.x > most.x || reach.y > most.y) {
    const double excess = std::max(reach.x / most.x, reach.y / most.y);
    dx /= excess;
    dy /= excess;
  }
  Covariance m{kPixelVariance * (dx.x * dx.x + dy.x * dy.x), kPixelVariance * (dx.y * dx.y + dy.y * dy.y),
               kPixelVariance * (dx.x * dx.y + dy.x * dy.y)};
  const double half = 0.5 * (m.a - m.b);
  const double half_difference = std::sqrt(half * half + m.c * m.c);
  const double major = 0.5 * (m.a + m.b) + half_difference;
  constexpr double kLeast = kLeastVariance;
  if (major <= kLeast) return {{kLeast, kLeast, 0}, kLeast, kLeast};
  // From the steps themselves: the difference of the covariance's near eigenvalues would lose a thin
  // ellipse's.
  const double area = kPixelVariance * (dx.x * dy.y - dx.y * dy.x);
  const double minor = area * area / major;
  const double least = std::max(kLeast, major / (longest * longest));
  if (minor >= least) return {m, major, minor};
  // To the minor axis alone: its projection is (major I - m) / (major - minor).
  if (half_difference > 0) {
    const double share = (least - minor) / (2 * half_difference);
    m = {m.a + share * (half_difference - half), m.b + share * (half_difference + half), m.c * (1 - share)};
  }
  return {m, major, least};
}

// What is read of a level: columns and rows of it that may lie outside the image. Columns count from the
// box's left, so that truncation is floor.
struct Box {
  int first_column;
  int last_column;
  int first_row;
  int last_row;
  float steepness;  // weights fall by this times the squared distance from the row's middle
};

Box find_box(const Covariance& rim, glm::dvec2 middle, Spans& spans) {
  const double per_height = 1 / rim.b;
  const double slope = rim.c * per_height;
  const double across = rim.a - slope * rim.c;  // the squared half width of the row through the middle
  const double half_height = std::sqrt(rim.b);
  const double half_width = std::sqrt(rim.a);
  // Texel i has its middle at i + 1/2.
  middle -= 0.5;
  const int left = static_cast<int>(whole(middle.x - half_width));
  const int top = static_cast<int>(whole(middle.y - half_height));
  const double x0 = middle.x - left;
  const double y0 = middle.y - top;
  const int last_column = static_cast<int>(x0 + half_width);
  const int rows = static_cast<int>(y0 + half_height);
  find_spans({.count = rows,
              .last_column = last_column,
              .first_dy = static_cast<float>(1 - y0),
              .middle = static_cast<float>(x0),
              .slope = static_cast<float>(slope),
              .across = static_cast<float>(across),
              .per_height = static_cast<float>(per_height)},
             spans);
  return {left, left + last_column, top + 1, top + rows, static_cast<float>(1 / across)};
}

// `first`..`last` of a row, one texel after the other in steps of `step`.
template <class Texel>
void add_texels(const Texel* texel, int step, int first, int last, float top, float middle, float steepness,
                Float4& sum) {
  auto dx = static_cast<float>(first) - middle;
  for (int x = first; x <= last; ++x, dx += 1, texel += step) {
    const float t = std::max(0.0f, top - steepness * dx * dx);
    sum += t * t * to_float4(*texel);
  }
}

// The coarsest level whose texels are small enough for the ellipse. Balanced, the variance along the minor
// axis may be less by the cube root of half the aspect: for x, the variance over kLeastVariance, that is x >=
// (2 / aspect)^(1/3), or x^6 aspect^2 >= 4.
int level_for(const Pyramid& pyramid, const Ellipse& ellipse, Detail detail) {
  const auto is_small_enough = [&](glm::dvec2 scale) {
    const double least = std::min(scale.x, scale.y);
    const double x = ellipse.minor * least * least / kLeastVariance;
    if (x >= 1 || detail == Detail::kFull) return x >= 1;
    return (x * x * x) * (x * x * x) * ellipse.major >= 4 * ellipse.minor;
  };
  // Where sizes halve evenly, minor 4^-level is kLeastVariance at this level or the next; others are near.
  const int last = pyramid.level_count() - 1;
  int level = std::clamp(std::ilogb(ellipse.minor / kLeastVariance) / 2, 0, last);
  while (level > 0 && !is_small_enough(pyramid.level(level).scale)) --level;
  while (level < last && is_small_enough(pyramid.level(level + 1).scale)) ++level;
  return level;
}

// The sum of the texels under the ellipse, weighed, and with it the sum of the weights.
template <class Texel>
Float4 weighed_sum(const Pyramid& pyramid, int level, Wrap wrap, const Covariance& rim, glm::dvec2 middle,
                   FilterScratch& scratch) {
  const Pyramid::Level& size = pyramid.level(level);
  const Spans& spans = scratch.spans;
  const Box box = find_box(rim, middle, scratch.spans);
  EllipseSum fours;
  if constexpr (std::is_same_v<Texel, IntegerTexel>) {
    const int column = box.first_column / kTileSide;
    const int row = box.first_row / kTileSide;
    if (box.first_column >= 0 && box.last_column < std::min(size.width, (column + 1) * kTileSide) &&
        box.first_row >= 0 && box.last_row < std::min(size.height, (row + 1) * kTileSide)) {
      const Texel* tile = pyramid.tile<Texel>(scratch.tiles, level, column, row);
      add_rows({.texels = tile + (box.first_row - row * kTileSide) * kTileSide,
                .next_row = kTileSide,
                .count = box.last_row - box.first_row + 1,
                .offset = box.first_column - column * kTileSide,
                .steepness = box.steepness},
               spans, fours);
      return fours.total();
    }
  }
  Float4 sum = {};
  cut_into_runs(box.first_row, box.last_row, size.height, wrap, scratch.rows);
  cut_into_runs(box.first_column, box.last_column, size.width, wrap, scratch.columns);
  for (const AxisRun& down : scratch.rows) {
    for (const AxisRun& across : scratch.columns) {
      const Texel* tile = pyramid.tile<Texel>(scratch.tiles, level, across.tile, down.tile);
      const int first_column = across.first - box.first_column;
      const int last_column = first_column + across.count - 1;
      const int first_row = down.first - box.first_row;
      if constexpr (std::is_same_v<Texel, IntegerTexel>) {
        if (across.step == 1) {
          add_rows({.texels = tile + down.offset * kTileSide,
                    .next_row = down.step * kTileSide,
                    .first_row = first_row,
                    .count = down.count,
                    .offset = across.offset - first_column,
                    .steepness = box.steepness,
                    .is_part = true,
                    .first_column = first_column,
                    .last_column = last_column},
                   spans, fours);
          continue;
        }
      }
      for (int k = 0; k < down.count; ++k) {
        const auto at = static_cast<std::size_t>(first_row) + static_cast<std::size_t>(k);
        const int first = std::max(spans.first[at], first_column);
        const int last = std::min(spans.last[at], last_column);
        const Texel* row = tile + (down.offset + k * down.step) * kTileSide;
        add_texels(row + across.offset + (first - first_column) * across.step, across.step, first, last,
                   spans.top[at], spans.middle[at], box.steepness, sum);
      }
    }
  }
  return sum + fours.total();
}

}  // namespace

glm::vec3 elliptical_average(const Pyramid& pyramid, Wrap wrap, const Footprint& footprint, Detail detail,
                             FilterScratch& scratch) {
  const Pyramid::Level& finest = pyramid.level(0);
  const glm::dvec2 size(finest.width, finest.height);
  const glm::dvec2 steps = (glm::abs(footprint.dx) + glm::abs(footprint.dy)) * size;
  const glm::dvec2 uv = footprint.uv;
  const bool is_finite = std::isfinite(steps.x + steps.y) && std::isfinite(uv.x + uv.y);
  if (!is_finite) return mean_of_all(pyramid, scratch.tiles);
  // v runs upwards, rows run down: the ellipse is mirrored with them.
  const Ellipse ellipse =
      ellipse_of(footprint.dx * glm::dvec2(size.x, -size.y), footprint.dy * glm::dvec2(size.x, -size.y), size,
                 detail == Detail::kFull ? kLongest : kLongestBalanced);
  const int level = level_for(pyramid, ellipse, detail);
  const glm::dvec2 scale = pyramid.level(level).scale;
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
