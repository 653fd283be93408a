// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Heckbert86], of which [Crow84] is order 1: the value is wy^T D wx, D entries of a table of n-fold
// sums, wx and wy the weights that spline_pieces.cpp finds for each axis. Departs from it in the arithmetic.
//   D is summed in unsigned 64-bit words that wrap round. No fraction may multiply such a word, so D is first
// made the sums over the box alone, whose true values are small enough:
//   S(i) = D(i) - sum_m C(i - a + m - 1, m) D^m(a),  m = 0..n-1,
// along y and then along x, takes off what the texels before a have left in column i. This is exact however
// often the words have wrapped; then S is converted to double and weighed. |S| < 2^bits C(L+n-1, n)^2 for a
// box of L texels must stay below 2^63: with 16-bit texels L is 11.8 million, 4,868 and 411 for n = 1, 2, 3.
// Longer pieces are cut, each with sums of its own: exact for any box, in a time that grows with the cuts.
//   A box that would take more than kMostParts pieces (order 3: past w = 685 a side, or 4,384 by 137) reads
//   the
// finest level of the pyramid where it does not. That differs by the levels' rounding, half a 16-bit step
// each at most, and by weighing 2^l texels alike where the spline would not: a box is hundreds of texels of
// the level wide, so a thousandth of what the texture varies within one of them.
//   Float texels become integers over the image's range: 2^32 steps for n = 1 and 2, 2^28 for n = 3.
//
// Symbols: D^m the m-th backward difference of D; a where a piece begins.

#include "repeated_integration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sweepkit::texmap {
namespace {

// Farther out than this many texels a double holds no fraction of one that would matter; the mean of all is
// the answer.
constexpr double kFarthest = 4503599627370496.0;  // 2^52
constexpr double kPixelVariance = 1.0 / 6;        // of a tent of one pixel each way
constexpr int kMostParts = 32;                    // that a box is cut into for the word, both axes together
constexpr int kFewTexels = 144;

using Double4 = double __attribute__((vector_size(32)));

// The longest piece whose sums a signed word holds.
int longest_piece(int order, int bits) {
  const double most = std::exp2(0.5 * (63 - bits));  // C(L + n - 1, n)
  const double factorial = order == 3 ? 6 : order;
  // (L + n)^n / n! is more than the binomial.
  return static_cast<int>(std::pow(factorial * most, 1.0 / order)) - order;
}

template <int order>
void add_block(const IntegralTable& table, const AxisPiece& across, const AxisPiece& down, TileReader& reader,
               std::array<double, 3>& total) {
  constexpr int kMost = (order + 1) * (order + 3);
  using Words = std::array<std::uint64_t, 3>;
  std::array<std::array<Words, kMost>, kMost> sums;
  const auto columns = static_cast<std::size_t>(across.count);
  const auto rows = static_cast<std::size_t>(down.count);
  for (std::size_t r = 0; r < rows; ++r) {
    const std::size_t zeros =
        static_cast<int>(r) < down.zeros ? columns : static_cast<std::size_t>(across.zeros);
    std::fill_n(sums[r].begin(), zeros, Words{});
  }
  for (int j = 0; j < down.run_count; ++j) {
    const ColumnRun& y = down.runs[static_cast<std::size_t>(j)];
    for (int i = 0; i < across.run_count; ++i) {
      const ColumnRun& x = across.runs[static_cast<std::size_t>(i)];
      const std::uint64_t* from = table.tile(reader, x.tile, y.tile) + 3 * (y.offset * kTileSide + x.offset);
      for (int r = 0; r < y.count; ++r, from += 3 * kTileSide) {
        std::uint64_t* to =
            sums[static_cast<std::size_t>(y.first + r)][static_cast<std::size_t>(x.first)].data();
        if (x.count == order + 1) {  // a knot by itself: a copy of known size
          std::copy_n(from, 3 * (order + 1), to);
        } else {
          std::copy_n(from, 3 * x.count, to);
        }
      }
    }
  }
  const auto distance = [](const AxisPiece& piece, std::size_t at) {
    return static_cast<std::uint64_t>(piece.column[at] - piece.column[order - 1]);
  };
  // Down: whole rows at once; the anchor's rows are zero from here on. `next` is what takes `continued` one
  // row on, and only a gap between rows costs a multiplication.
  const auto row_words = 3 * columns;
  const std::uint64_t* last = sums[order - 1].front().data();
  const std::uint64_t* before = sums[std::max(order - 2, 0)].front().data();
  const std::uint64_t* first = sums[0].front().data();
  std::array<std::uint64_t, 3 * kMost> slope;
  std::array<std::uint64_t, 3 * kMost> bend;
  std::array<std::uint64_t, 3 * kMost> next;
  std::array<std::uint64_t, 3 * kMost> continued;
  for (std::size_t at = 0; at < row_words; ++at) {
    slope[at] = last[at] - before[at];
    bend[at] = slope[at] - before[at] + first[at];
  }
  for (std::size_t r = order; r < rows; ++r) {
    std::uint64_t* row = sums[r].front().data();
    const std::uint64_t d = distance(down, r);
    if (r > order && d == distance(down, r - 1) + 1) {
      for (std::size_t at = 0; at < row_words; ++at) {
        if constexpr (order >= 2) continued[at] += next[at];
        if constexpr (order == 3) next[at] += bend[at];
        row[at] -= continued[at];
      }
      continue;
    }
    const std::uint64_t dd = d * (d + 1) / 2;
    for (std::size_t at = 0; at < row_words; ++at) {
      continued[at] = last[at];
      if constexpr (order >= 2) continued[at] += d * slope[at];
      if constexpr (order == 3) continued[at] += dd * bend[at];
      next[at] = slope[at];
      if constexpr (order == 3) next[at] += (d + 1) * bend[at];
      row[at] -= continued[at];
    }
  }
  // Across, and weigh.
  std::array<std::uint64_t, kMost> d{};
  std::array<std::uint64_t, kMost> dd{};
  for (std::size_t c = order; c < columns; ++c) {
    d[c] = distance(across, c);
    dd[c] = d[c] * (d[c] + 1) / 2;
  }
  for (std::size_t r = order; r < rows; ++r) {
    const auto& row = sums[r];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t sum = row[order - 1][k];
      const std::uint64_t by_one = sum - row[std::max(order - 2, 0)][k];
      const std::uint64_t by_two = by_one - row[std::max(order - 2, 0)][k] + row[0][k];
      double weighed = 0;
      for (std::size_t c = order; c < columns; ++c) {
        std::uint64_t value = row[c][k] - sum;
        if constexpr (order >= 2) value -= d[c] * by_one;
        if constexpr (order == 3) value -= dd[c] * by_two;
        weighed += across.weight[c] * static_cast<double>(static_cast<std::int64_t>(value));
      }
      total[k] += down.weight[r] * weighed;
    }
  }
}

FixedPoint fixed_point_of(const Pyramid& pyramid, int order) {
  FixedPoint fixed;
  if (!pyramid.is_float()) {
    const IntegerTexel first = pyramid.read<IntegerTexel>(0, {0, 0, 1, 1}).front();
    for (std::size_t k = 0; k < 3; ++k) {
      fixed.zero[k] = first[k];
      fixed.origin[k] = first[k] / 65535.0;
      fixed.step[k] = 1 / 65535.0;
    }
    return fixed;
  }
  fixed.bits = order == 3 ? 28 : 32;
  const Pyramid::Level& size = pyramid.level(0);
  std::array<float, 3> low;
  std::array<float, 3> high;
  low.fill(std::numeric_limits<float>::max());
  high.fill(std::numeric_limits<float>::lowest());
  for (int y = 0; y < size.height; y += kTileSide) {
    const PixelRect band{0, y, size.width, std::min(kTileSide, size.height - y)};
    for (const FloatTexel& texel : pyramid.read<FloatTexel>(0, band)) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], texel[k]);
        high[k] = std::max(high[k], texel[k]);
      }
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    fixed.origin[k] = fixed.zero[k] = low[k];
    const double range = static_cast<double>(high[k]) - fixed.zero[k];
    fixed.step[k] = range / (std::exp2(fixed.bits) - 1);
    fixed.scale[k] = range > 0 ? (std::exp2(fixed.bits) - 1) / range : 0;
  }
  return fixed;
}

// Boxes of any width may be asked for; n together vary as one of a texel at least, which for n = 1 is
// bilinear interpolation.
SplineInterval widened(const SplineInterval& interval, int order) {
  const double least = 1 / std::sqrt(order);
  if (interval.width >= least) return interval;
  return {interval.left - 0.5 * order * (least - interval.width), least};
}

}  // namespace

RepeatedIntegration::RepeatedIntegration(const Pyramid& pyramid, Wrap wrap, int order, TileCache& cache,
                                         std::uint32_t id)
    : pyramid_(pyramid), wrap_(wrap), order_(order), cache_(cache), id_(id) {}

const RepeatedIntegration::Tables& RepeatedIntegration::tables() const {
  std::call_once(once_, [&] {
    Tables made{fixed_point_of(pyramid_, order_), 0, {}};
    made.longest = longest_piece(order_, made.fixed_point.bits);
    for (int level = 0; level < pyramid_.level_count(); ++level) {
      made.levels.push_back(
          std::make_unique<const IntegralTable>(pyramid_, level, order_, made.fixed_point, cache_, id_));
    }
    tables_ = std::move(made);
  });
  return tables_;
}

glm::vec3 RepeatedIntegration::over_pixel(const Footprint& footprint, FilterScratch& scratch) const {
  const glm::dvec2 size(pyramid_.level(0).width, pyramid_.level(0).height);
  // n boxes of width w have a variance of n w^2 / 12, a pixel kPixelVariance times its steps' squares.
  const double scale = std::sqrt(12 * kPixelVariance / order_);
  const auto along = [&](double middle, double dx, double dy, double texels) {
    const double width = scale * texels * std::sqrt(dx * dx + dy * dy);
    return SplineInterval{middle * texels - 0.5 * order_ * width, width};
  };
  return filter(along(footprint.uv.x, footprint.dx.x, footprint.dy.x, size.x),
                along(1 - footprint.uv.y, footprint.dx.y, footprint.dy.y, size.y), scratch);
}

glm::vec3 RepeatedIntegration::over_box(const UvBox& box, FilterScratch& scratch) const {
  const glm::dvec2 size(pyramid_.level(0).width, pyramid_.level(0).height);
  const auto along = [&](double from, double to) { return SplineInterval{from, (to - from) / order_}; };
  return filter(along(box.min.x * size.x, box.max.x * size.x),
                along((1 - box.max.y) * size.y, (1 - box.min.y) * size.y), scratch);
}

int RepeatedIntegration::level_for(const SplineInterval& x, const SplineInterval& y, int longest) const {
  const Pyramid::Level& finest = pyramid_.level(0);
  // What is left to sum along an axis once whole periods, or what lies outside, are means.
  const auto parts = [&](double width, int size, int finest_size) {
    const double most = wrap_ == Wrap::kClamp ? size : (wrap_ == Wrap::kMirror ? 2.0 : 1.0) * order_ * size;
    return std::ceil(std::min(order_ * width * size / finest_size, most) / longest);
  };
  int level = 0;
  while (level + 1 < pyramid_.level_count()) {
    const Pyramid::Level& size = pyramid_.level(level);
    if (parts(x.width, size.width, finest.width) * parts(y.width, size.height, finest.height) <= kMostParts)
      break;
    ++level;
  }
  return level;
}

// The texels themselves. In words, as a table gives them.
template <class Texel>
std::array<double, 3> RepeatedIntegration::weigh(const SplineInterval& x, const SplineInterval& y,
                                                 FilterScratch& scratch) const {
  std::array<double, kFewTexels> across;
  std::array<double, kFewTexels> down;
  const auto cut = [&](SplineInterval interval, int size, std::array<double, kFewTexels>& weights,
                       std::vector<AxisRun>& runs) {
    const double support = order_ * interval.width;
    if (wrap_ == Wrap::kClamp) {
      interval.left = std::clamp(interval.left, -support - 1, size + 1.0);
    } else {
      const double period = wrap_ == Wrap::kMirror ? 2.0 * size : size;
      interval.left -= period * std::floor(interval.left / period);
    }
    const int first = static_cast<int>(std::floor(interval.left));
    const int last = static_cast<int>(std::ceil(interval.left + support)) - 1;
    weigh_texels(interval, order_, first, {weights.data(), static_cast<std::size_t>(last - first + 1)});
    cut_into_runs(first, last, size, wrap_, runs);
    return first;
  };
  const int first_column = cut(x, pyramid_.level(0).width, across, scratch.columns);
  const int first_row = cut(y, pyramid_.level(0).height, down, scratch.rows);
  Double4 origin;
  Double4 sum = {};
  for (std::size_t k = 0; k < 3; ++k) origin[k] = tables_.fixed_point.zero[k];
  origin[3] = 0;
  for (const AxisRun& rows : scratch.rows) {
    for (const AxisRun& columns : scratch.columns) {
      const Texel* tile = pyramid_.tile<Texel>(scratch.tiles, 0, columns.tile, rows.tile);
      for (int j = 0; j < rows.count; ++j) {
        const Texel* texel = tile + (rows.offset + j * rows.step) * kTileSide + columns.offset;
        const double* weight = across.data() + (columns.first - first_column);
        Double4 row = {};
        for (int i = 0; i < columns.count; ++i, texel += columns.step)
          row += weight[i] * (__builtin_convertvector(*texel, Double4) - origin);
        sum += down[static_cast<std::size_t>(rows.first + j - first_row)] * row;
      }
    }
  }
  std::array<double, 3> words;
  for (std::size_t k = 0; k < 3; ++k) words[k] = sum[k] * tables_.fixed_point.scale[k];
  return words;
}

glm::vec3 RepeatedIntegration::filter(SplineInterval x, SplineInterval y, FilterScratch& scratch) const {
  const Tables& made = tables();
  const auto color_of = [&](const std::array<double, 3>& sum) {
    glm::dvec3 color;
    for (std::size_t k = 0; k < 3; ++k)
      color[static_cast<glm::length_t>(k)] = made.fixed_point.origin[k] + made.fixed_point.step[k] * sum[k];
    return glm::vec3(color);
  };
  // Written so that NaN, too, takes the mean of all.
  const auto is_usable = [&](const SplineInterval& interval) {
    return interval.width >= 0 && interval.left > -kFarthest &&
           interval.left + order_ * interval.width < kFarthest;
  };
  const Pyramid::Level& finest = pyramid_.level(0);
  std::array<double, 3> words{};
  if (!is_usable(x) || !is_usable(y)) {
    const auto& total = made.levels.front()->carries().total();
    for (std::size_t k = 0; k < 3; ++k) {
      words[k] = static_cast<double>(static_cast<std::int64_t>(total[k])) /
                 (static_cast<double>(finest.width) * finest.height);
    }
    return color_of(words);
  }
  x = widened(x, order_);
  y = widened(y, order_);
  if (std::ceil(order_ * x.width + 1) * std::ceil(order_ * y.width + 1) <= kFewTexels) {
    return color_of(pyramid_.is_float() ? weigh<FloatTexel>(x, y, scratch)
                                        : weigh<IntegerTexel>(x, y, scratch));
  }
  const int index = level_for(x, y, made.longest);
  const Pyramid::Level& size = pyramid_.level(index);
  const auto scaled = [](const SplineInterval& interval, int texels, int finest_texels) {
    const double scale = static_cast<double>(texels) / finest_texels;
    return SplineInterval{scale * interval.left, scale * interval.width};
  };
  cut_into_pieces(scaled(x, size.width, finest.width), order_, size.width, wrap_, made.longest,
                  scratch.across);
  cut_into_pieces(scaled(y, size.height, finest.height), order_, size.height, wrap_, made.longest,
                  scratch.down);
  const IntegralTable& table = *made.levels[static_cast<std::size_t>(index)];
  table.carries();
  for (const AxisPiece& down : scratch.down) {
    for (const AxisPiece& across : scratch.across) {
      if (order_ == 1) add_block<1>(table, across, down, scratch.tables, words);
      if (order_ == 2) add_block<2>(table, across, down, scratch.tables, words);
      if (order_ == 3) add_block<3>(table, across, down, scratch.tables, words);
    }
  }
  return color_of(words);
}

std::size_t RepeatedIntegration::bytes() const {
  std::size_t bytes = 0;
  for (const auto& level : tables_.levels) bytes += level->bytes();
  return bytes;
}

}  // namespace sweepkit::texmap
