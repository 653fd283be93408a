// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A pixel falls on the texture as the parallelogram of its two steps. Texels are weighed by how much of them
// lies under it: along either step the overlap of two intervals, the parallelogram's and the texel's shadow
// on that step. Their product is the texel's share to the bit where the parallelogram lies along the
// texture's axes, and close to it elsewhere where texels are smaller than the pixel. It is read from the
// coarsest level at which the parallelogram is still kLeastWidth texels across; where it is narrower than
// that along one axis of the finest one, the texels are cut into parts along that axis.
//
// Symbols, in texels of a level, rows downwards: e and f the steps of a pixel to the right and down, det =
// e.x f.y - e.y f.x; a texel at d from the middle is s = (d.x f.y - d.y f.x) / det pixels to the right and t
// = (d.y e.x - d.x e.y) / det down, and as wide as (|f.x| + |f.y|) / |det| and (|e.x| + |e.y|) / |det|
// pixels.

#include "parallelogram_average.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "mip_filter.hpp"

namespace sweepkit::texmap {
namespace {

constexpr double kLeastWidth = 2;
constexpr double kLongest = 128;  // along an axis, in texels of the level
constexpr double kMostTextures = 4;
constexpr double kNarrowest = 1.0 / 256;  // in texels: beyond that the weights lose their digits
constexpr double kMostParts = 512;        // which such a one needs, at most

// How much of a texel lies between the pixel's two edges along one step: at a distance of `at` pixels.
struct Overlap {
  float reach;  // where it ends
  float whole;  // at the middle
  float step;   // of `at`, from a texel to the next of a row
  double step_right;
  double step_down;     // from a row to the next
  double texels_right;  // 1 over the step to the right; 0 where that is 0

  template <class Number>
  Number of(Number at) const {
    const Number distance = at < 0 ? -at : at;
    const Number part = reach - distance;
    const Number inside = part > 0 ? part : Number{};
    return inside < whole ? inside : Number{} + whole;
  }
};

struct Shape {
  glm::dvec2 half;  // of its box, and half a texel
  Overlap across;
  Overlap down;
};

Overlap overlap_for(double step_right, double step_down) {
  const double texel = std::abs(step_right) + std::abs(step_down);
  return {static_cast<float>(0.5 * (1 + texel)),
          static_cast<float>(std::min(1.0, texel)),
          static_cast<float>(step_right),
          step_right,
          step_down,
          step_right != 0 ? 1 / step_right : 0};
}

// Texels first..last of a row, the left one `s` and `t` away.
struct RowSpan {
  int first;
  int last;
  double s;
  double t;
};

// x for which |at + x step| < reach.
void narrow(double at, const Overlap& overlap, double& low, double& high) {
  const auto reach = static_cast<double>(overlap.reach);
  if (overlap.step_right == 0) {
    if (std::abs(at) >= reach) high = low - 1;
    return;
  }
  const double middle = -at * overlap.texels_right;
  const double half = reach * std::abs(overlap.texels_right);
  low = std::max(low, middle - half);
  high = std::min(high, middle + half);
}

// The texels of row `y` that may weigh something; `first` after `last` where there are none.
RowSpan span_of(const Shape& shape, const glm::dvec2& middle, int y) {
  // Of the texel at column 0.
  const double dx = 0.5 - middle.x;
  const double dy = y + 0.5 - middle.y;
  const double s = dx * shape.across.step_right + dy * shape.across.step_down;
  const double t = dx * shape.down.step_right + dy * shape.down.step_down;
  double low = -dx - shape.half.x;
  double high = -dx + shape.half.x;
  narrow(s, shape.across, low, high);
  narrow(t, shape.down, low, high);
  // Where nothing is left the ends may be farther off than integers reach.
  if (!(low <= high)) return {0, -1, 0, 0};
  const int first = static_cast<int>(-whole(-low));
  const int last = static_cast<int>(whole(high));
  return {first, last, s + first * shape.across.step_right, t + first * shape.down.step_right};
}

template <class Texel>
void add_texels(const Texel* texel, int texel_step, int count, const Shape& shape, double s, double t,
                Float4& sum) {
  auto at_s = static_cast<float>(s);
  auto at_t = static_cast<float>(t);
  Float4 row = {};  // rows first, then their sums: some hundred roundings instead of some ten thousand
  for (int i = 0; i < count; ++i, texel += texel_step) {
    row += shape.across.of(at_s) * shape.down.of(at_t) * to_float4(*texel);
    at_s += shape.across.step;
    at_t += shape.down.step;
  }
  sum += row;
}

// The same by fours, for a row whose texels lie in one tile, the first at `offset`. What lies beside them in
// the tile weighs nothing, whatever it is: an oblique parallelogram's weights go on past its bounding box,
// where the span ends, and past the image's edge a tile holds no texels. Integers are never NaN.
void add_fours(const IntegerTexel* row, int offset, int count, const Shape& shape, double s, double t,
               Float4& sum) {
  const int fours = (count + 3) / 4;
  const int first = std::min(offset, kTileSide - 4 * fours);  // none reaches past the row's end
  const IntegerTexel* texel = row + first;
  Float4 index = Float4{0, 1, 2, 3} + static_cast<float>(first - offset);
  const auto end = static_cast<float>(count);
  Float4 at_s = static_cast<float>(s) + index * shape.across.step;
  Float4 at_t = static_cast<float>(t) + index * shape.down.step;
  Float4 even = {};
  Float4 odd = {};
  for (int i = 0; i < fours; ++i) {
    Float4 w = shape.across.of(at_s) * shape.down.of(at_t);
    w = index >= 0 ? w : Float4{};
    w = index < end ? w : Float4{};
    even += __builtin_shufflevector(w, w, 0, 0, 0, 0) * to_float4(texel[0]);
    odd += __builtin_shufflevector(w, w, 1, 1, 1, 1) * to_float4(texel[1]);
    even += __builtin_shufflevector(w, w, 2, 2, 2, 2) * to_float4(texel[2]);
    odd += __builtin_shufflevector(w, w, 3, 3, 3, 3) * to_float4(texel[3]);
    index += 4;
    at_s += 4 * shape.across.step;
    at_t += 4 * shape.down.step;
    texel += 4;
  }
  sum += even + odd;
}

constexpr int kTexelsALine = 64 / sizeof(IntegerTexel);  // of the cache

template <class Texel>
Float4 weighed_sum(const Pyramid& pyramid, int level, Wrap wrap, const Shape& shape, const glm::dvec2& middle,
                   FilterScratch& scratch) {
  const Pyramid::Level& size = pyramid.level(level);
  const auto first_column = static_cast<int>(whole(middle.x - shape.half.x));
  const auto last_column = static_cast<int>(whole(middle.x + shape.half.x));
  const auto first_row = static_cast<int>(whole(middle.y - shape.half.y));
  const auto last_row = static_cast<int>(whole(middle.y + shape.half.y));
  cut_into_runs(first_row, last_row, size.height, wrap, scratch.rows);
  cut_into_runs(first_column, last_column, size.width, wrap, scratch.columns);
  Float4 sum = {};
  for (const AxisRun& rows : scratch.rows) {
    for (const AxisRun& columns : scratch.columns) {
      const Texel* tile = pyramid.tile<Texel>(scratch.tiles, level, columns.tile, rows.tile);
      // All rows are asked for before the first is waited for.
      for (int k = 0; k < rows.count; ++k) {
        const Texel* row = tile + (rows.offset + k * rows.step) * kTileSide + columns.offset;
        for (int i = 0; i < columns.count; i += kTexelsALine) __builtin_prefetch(row + i);
      }
      for (int k = 0; k < rows.count; ++k) {
        const RowSpan span = span_of(shape, middle, rows.first + k);
        const int first = std::max(span.first, columns.first);
        const int last = std::min(span.last, columns.first + columns.count - 1);
        if (first > last) continue;
        const Texel* row = tile + (rows.offset + k * rows.step) * kTileSide;
        if constexpr (std::is_same_v<Texel, IntegerTexel>) {
          if (columns.step == 1 && first == span.first && last == span.last) {
            add_fours(row, columns.offset + first - columns.first, last - first + 1, shape, span.s, span.t,
                      sum);
            continue;
          }
        }
        add_texels(row + columns.offset + (first - columns.first) * columns.step, columns.step,
                   last - first + 1, shape, span.s + (first - span.first) * shape.across.step_right,
                   span.t + (first - span.first) * shape.down.step_right, sum);
      }
    }
  }
  return sum;
}

int floor_of_quotient(int n, int by) {
  return n >= 0 ? n / by : -((by - 1 - n) / by);
}

// Of the finest level, its texels cut into `parts` along either axis; all lengths in such parts.
template <class Texel>
Float4 sum_of_parts(const Pyramid& pyramid, Wrap wrap, const glm::ivec2& parts, const Shape& shape,
                    const glm::dvec2& middle, FilterScratch& scratch) {
  const Pyramid::Level& size = pyramid.level(0);
  const auto first_row = static_cast<int>(whole(middle.y - shape.half.y));
  const auto last_row = static_cast<int>(whole(middle.y + shape.half.y));
  Float4 sum = {};
  for (int y = first_row; y <= last_row; ++y) {
    const RowSpan span = span_of(shape, middle, y);
    const int row = wrapped(floor_of_quotient(y, parts.y), size.height, wrap).texel;
    for (int x = span.first; x <= span.last;) {
      const int column = floor_of_quotient(x, parts.x);
      float weight = 0;
      for (const int end = std::min(span.last + 1, (column + 1) * parts.x); x < end; ++x) {
        const auto s = static_cast<float>(span.s) + static_cast<float>(x - span.first) * shape.across.step;
        const auto t = static_cast<float>(span.t) + static_cast<float>(x - span.first) * shape.down.step;
        weight += shape.across.of(s) * shape.down.of(t);
      }
      const int texel = wrapped(column, size.width, wrap).texel;
      const Texel* tile = pyramid.tile<Texel>(scratch.tiles, 0, texel / kTileSide, row / kTileSide);
      sum += weight * to_float4(tile[row % kTileSide * kTileSide + texel % kTileSide]);
    }
  }
  return sum;
}

Shape shape_of(const glm::dvec2& e, const glm::dvec2& f) {
  const double det = e.x * f.y - e.y * f.x;
  return {0.5 * (glm::abs(e) + glm::abs(f) + 1.0), overlap_for(f.y / det, -f.x / det),
          overlap_for(-e.y / det, e.x / det)};
}

}  // namespace

std::optional<glm::vec3> parallelogram_average(const Pyramid& pyramid, Wrap wrap, const Footprint& footprint,
                                               FilterScratch& scratch) {
  const Pyramid::Level& finest = pyramid.level(0);
  const glm::dvec2 size(finest.width, finest.height);
  // v runs upwards, rows run down.
  const glm::dvec2 flip(size.x, -size.y);
  glm::dvec2 e = footprint.dx * flip;
  glm::dvec2 f = footprint.dy * flip;
  const glm::dvec2 extent = glm::abs(e) + glm::abs(f);
  if (!std::isfinite(extent.x + extent.y) || !std::isfinite(footprint.uv.x + footprint.uv.y))
    return std::nullopt;
  const double longer = std::sqrt(std::max(glm::dot(e, e), glm::dot(f, f)));
  const glm::dvec2 textures = extent / size;
  if (longer < 1 || std::max(textures.x, textures.y) > kMostTextures) return std::nullopt;
  const double width = std::abs(e.x * f.y - e.y * f.x) / longer;  // between the longer sides
  if (width < kNarrowest) return std::nullopt;
  const glm::dvec2 middle = near_origin(glm::dvec2(footprint.uv.x, 1 - footprint.uv.y), wrap) * size;
  Float4 sum;
  if (std::min(extent.x, extent.y) < kLeastWidth) {
    const glm::dvec2 parts = glm::min(glm::ceil(kLeastWidth / extent), glm::dvec2(kMostParts));
    if (std::max(extent.x * parts.x, extent.y * parts.y) > kLongest) return std::nullopt;
    const Shape shape = shape_of(e * parts, f * parts);
    sum = pyramid.is_float()
              ? sum_of_parts<FloatTexel>(pyramid, wrap, parts, shape, middle * parts, scratch)
              : sum_of_parts<IntegerTexel>(pyramid, wrap, parts, shape, middle * parts, scratch);
  } else {
    int level = 0;
    while (level + 1 < pyramid.level_count()) {
      const glm::dvec2& coarser = pyramid.level(level + 1).scale;
      if (width * std::min(coarser.x, coarser.y) < kLeastWidth) break;
      ++level;
    }
    const glm::dvec2& scale = pyramid.level(level).scale;
    if (std::max(extent.x * scale.x, extent.y * scale.y) > kLongest) return std::nullopt;
    const Shape shape = shape_of(e * scale, f * scale);
    sum = pyramid.is_float()
              ? weighed_sum<FloatTexel>(pyramid, level, wrap, shape, middle * scale, scratch)
              : weighed_sum<IntegerTexel>(pyramid, level, wrap, shape, middle * scale, scratch);
  }
  if (!(sum[3] > 0)) return std::nullopt;
  return glm::vec3(sum[0], sum[1], sum[2]) / sum[3];
}

}  // namespace sweepkit::texmap
