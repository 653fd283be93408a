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
// Most footprints lie in one tile as a whole. There a row's texels are taken by fours, past both ends of its
// span: one branch for four texels, and those beside the ellipse weigh nothing.
//
// Symbols, in texels of a level: (a c; c b) is the covariance times kRim, so that q = d^T (a c; c b)^-1 d. In
// the row dy below the middle q is least, dy^2 / b, at dx = c / b dy, and grows from there by (dx)^2 / (a -
// c^2 / b).

#include "elliptical_average.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "mip_filter.hpp"

namespace sweepkit::texmap {
namespace {

constexpr double kPixelVariance = 1.0 / 6;
constexpr double kRim = 8;  // (1 - q)^2 has a variance of 1/8 of the squared radius along each axis
constexpr double kLeastVariance = 0.25;
constexpr double kLongest = 64;
constexpr double kMostTextures = 4;  // an ellipse's radius along u or v

struct Covariance {
  double a = 0;  // of x
  double b = 0;  // of y
  double c = 0;  // of both

  double half_difference() const { return std::sqrt(0.25 * (a - b) * (a - b) + c * c); }
  double major() const { return 0.5 * (a + b) + half_difference(); }
};

// The covariance of a footprint, in texels of the finest level, with axes that can be worked with, and the
// variances along them.
struct Ellipse {
  Covariance covariance;
  double major = 0;
  double minor = 0;
};

Ellipse ellipse_of(glm::dvec2 dx, glm::dvec2 dy, glm::dvec2 size) {
  // Radii beyond a few textures change nothing where the texture repeats, and little where it does not.
  const double reach_x =
      std::sqrt(kRim * kPixelVariance) * (std::abs(dx.x) + std::abs(dy.x)) / (kMostTextures * size.x);
  const double reach_y =
      std::sqrt(kRim * kPixelVariance) * (std::abs(dx.y) + std::abs(dy.y)) / (kMostTextures * size.y);
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
  constexpr double kLeast = kLeastVariance;
  const double least = std::max(kLeast, major / (kLongest * kLongest));
  if (major <= kLeast) return {{kLeast, kLeast, 0}, kLeast, kLeast};
  if (minor >= least) return {m, major, minor};
  // To the minor axis alone: its projection is (major I - m) / (major - minor).
  const double half_difference = m.half_difference();
  if (half_difference > 0) {
    const double share = (least - minor) / (2 * half_difference);
    const double half = 0.5 * (m.a - m.b);
    m = {m.a + share * (half_difference - half), m.b + share * (half_difference + half), m.c * (1 - share)};
  }
  return {m, major, least};
}

// What is read of a level: columns and rows of it that may lie outside the image, and the part of each row
// that lies under the ellipse. Columns count from the box's left, so that truncation is floor.
struct Box {
  int first_column;
  int last_column;
  int first_row;
  int last_row;
  float steepness;  // weights fall by this times the squared distance from the row's middle
};

Box find_spans(const Covariance& rim, glm::dvec2 middle, std::vector<Span>& spans) {
  const double slope = rim.c / rim.b;
  const double across = rim.a - slope * rim.c;  // the squared half width of the row through the middle
  const double half_height = std::sqrt(rim.b);
  const double half_width = std::sqrt(rim.a);
  // Texel i has its middle at i + 1/2.
  middle -= 0.5;
  const auto left = static_cast<int>(std::floor(middle.x - half_width));
  const auto top = static_cast<int>(std::floor(middle.y - half_height));
  const double x0 = middle.x - left;
  const double y0 = middle.y - top;
  const Box box{left, left + static_cast<int>(x0 + half_width), top + 1,
                top + static_cast<int>(y0 + half_height), static_cast<float>(1 / across)};
  const auto count = static_cast<std::size_t>(std::max(0, box.last_row - top));
  if (spans.size() < count) spans.resize(count);
  const double per_height = 1 / rim.b;
  for (std::size_t k = 0; k < count; ++k) {
    const double dy = static_cast<double>(static_cast<int>(k) + 1) - y0;
    const double rest = std::max(0.0, 1 - dy * dy * per_height);
    const double x = x0 + slope * dy;
    const double half = std::sqrt(rest * across);
    // Texels on the rim itself weigh nothing and may be in or out.
    spans[k] = {static_cast<int>(x - half), static_cast<int>(x + half), static_cast<float>(rest),
                static_cast<float>(x)};
  }
  return box;
}

// `first`..`last` of a row, one texel after the other in steps of `step`.
template <class Texel>
void add_texels(const Texel* texel, int step, int first, int last, const Span& span, float steepness,
                Float4& sum) {
  auto dx = static_cast<float>(first) - span.middle;
  for (int x = first; x <= last; ++x, dx += 1, texel += step) {
    const float t = std::max(0.0f, span.top - steepness * dx * dx);
    sum += t * t * to_float4(*texel);
  }
}

// A span that lies in one tile as a whole, four texels at a time. `row` is the tile's, `offset` where the box
// begins in it. Texels beside the span weigh nothing, whatever they are; integers are never NaN.
void add_span(const IntegerTexel* row, int offset, const Span& span, float steepness, Float4& even,
              Float4& odd) {
  const int fours = (span.last - span.first + 4) / 4;
  const int first = std::min(offset + span.first, kTileSide - 4 * fours);  // none reaches past the row's end
  const IntegerTexel* texel = row + first;
  Float4 dx = Float4{0, 1, 2, 3} + (static_cast<float>(first - offset) - span.middle);
  for (int i = 0; i < fours; ++i) {
    const Float4 t = span.top - steepness * dx * dx;
    const Float4 root = t > 0 ? t : Float4{};
    const Float4 w = root * root;
    even += __builtin_shufflevector(w, w, 0, 0, 0, 0) * to_float4(texel[0]);
    odd += __builtin_shufflevector(w, w, 1, 1, 1, 1) * to_float4(texel[1]);
    even += __builtin_shufflevector(w, w, 2, 2, 2, 2) * to_float4(texel[2]);
    odd += __builtin_shufflevector(w, w, 3, 3, 3, 3) * to_float4(texel[3]);
    dx += 4;
    texel += 4;
  }
}

// The coarsest level whose texels are small enough for the ellipse. Balanced, the variance along the minor
// axis may be less by the cube root of a quarter of the aspect, but no less than two fifths: for x, the
// variance over kLeastVariance, that is x >= (4 / aspect)^(1/3), or x^6 aspect^2 >= 16.
int level_for(const Pyramid& pyramid, const Ellipse& ellipse, Detail detail) {
  const double aspect_squared = ellipse.major / ellipse.minor;
  const auto is_small_enough = [&](glm::dvec2 scale) {
    const double least = std::min(scale.x, scale.y);
    const double x = ellipse.minor * least * least / kLeastVariance;
    if (x >= 1 || detail == Detail::kFull) return x >= 1;
    return x >= 0.4 && (x * x * x) * (x * x * x) * aspect_squared >= 16;
  };
  int level = 0;
  while (level + 1 < pyramid.level_count() && is_small_enough(pyramid.level(level + 1).scale)) ++level;
  return level;
}

// The sum of the texels under the ellipse, weighed, and with it the sum of the weights.
template <class Texel>
Float4 weighed_sum(const Pyramid& pyramid, int level, Wrap wrap, const Covariance& rim, glm::dvec2 middle,
                   FilterScratch& scratch) {
  const Pyramid::Level& size = pyramid.level(level);
  const Box box = find_spans(rim, middle, scratch.spans);
  Float4 sum = {};
  if constexpr (std::is_same_v<Texel, IntegerTexel>) {
    const int column = box.first_column / kTileSide;
    const int row = box.first_row / kTileSide;
    if (box.first_column >= 0 && box.last_column < std::min(size.width, (column + 1) * kTileSide) &&
        box.first_row >= 0 && box.last_row < std::min(size.height, (row + 1) * kTileSide)) {
      const Texel* texels = pyramid.tile<Texel>(scratch.tiles, level, column, row) +
                            (box.first_row - row * kTileSide) * kTileSide;
      Float4 odd = {};
      for (int k = 0; k <= box.last_row - box.first_row; ++k) {
        add_span(texels + k * kTileSide, box.first_column - column * kTileSide,
                 scratch.spans[static_cast<std::size_t>(k)], box.steepness, sum, odd);
      }
      return sum + odd;
    }
  }
  cut_into_runs(box.first_row, box.last_row, size.height, wrap, scratch.rows);
  cut_into_runs(box.first_column, box.last_column, size.width, wrap, scratch.columns);
  for (const AxisRun& rows : scratch.rows) {
    for (const AxisRun& columns : scratch.columns) {
      const Texel* tile = pyramid.tile<Texel>(scratch.tiles, level, columns.tile, rows.tile);
      const int first_column = columns.first - box.first_column;
      for (int k = 0; k < rows.count; ++k) {
        const Span& span = scratch.spans[static_cast<std::size_t>(rows.first + k - box.first_row)];
        const int first = std::max(span.first, first_column);
        const int last = std::min(span.last, first_column + columns.count - 1);
        const Texel* row = tile + (rows.offset + k * rows.step) * kTileSide;
        add_texels(row + columns.offset + (first - first_column) * columns.step, columns.step, first, last,
                   span, box.steepness, sum);
      }
    }
  }
  return sum;
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
  const Ellipse ellipse = ellipse_of(footprint.dx * glm::dvec2(size.x, -size.y),
                                     footprint.dy * glm::dvec2(size.x, -size.y), size);
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
