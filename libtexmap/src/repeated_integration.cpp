// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Heckbert86], of which [Crow84] is order 1: the value is wy^T D wx, D entries of a table of n-fold
// sums, wx and wy the weights that spline_pieces.cpp finds for each axis. Departs from it in the arithmetic.
//
// D is summed in unsigned 64-bit words that wrap round, and integral_block.cpp makes of it the sums S over a
// box alone, exact as long as |S| < 2^bits C(L+n-1, n)^2 stays below 2^63 for a box of L texels: with 16-bit
// texels L is 11.8 million, 4,868 and 411 for n = 1, 2, 3. Longer boxes are cut, each piece with sums of its
// own: exact for any box, in a time that grows with the pieces.
//
// A box that would take more than kMostParts pieces (order 3: past w = 685 a side, or 4,384 by 137) reads the
// finest level of the pyramid where it does not. That differs by the levels' rounding, half a 16-bit step
// each at most, and by weighing 2^l texels alike where the spline would not: a box is hundreds of texels of
// the level wide, so a thousandth of what the texture varies within one of them.
//
// A box of few texels weighs them one by one: quicker than the table, and the same. Float texels become
// integers over the image's range: 2^32 steps for n = 1 and 2, 2^28 for n = 3.

#include "repeated_integration.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "integral_block.hpp"

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
    Tables made{fixed_point_of(pyramid_, order_ == 3 ? 28 : 32), 0, {}};
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
  const auto color_of = [&](const std::array<double, 3>& sum, double weights) {
    glm::dvec3 color;
    for (std::size_t k = 0; k < 3; ++k)
      color[static_cast<glm::length_t>(k)] = made.fixed_point.light(sum[k] / weights, k);
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
    for (std::size_t k = 0; k < 3; ++k) words[k] = static_cast<double>(static_cast<std::int64_t>(total[k]));
    return color_of(words, static_cast<double>(finest.width) * finest.height);
  }
  x = widened(x, order_);
  y = widened(y, order_);
  if (std::ceil(order_ * x.width + 1) * std::ceil(order_ * y.width + 1) <= kFewTexels) {
    return color_of(
        pyramid_.is_float() ? weigh<FloatTexel>(x, y, scratch) : weigh<IntegerTexel>(x, y, scratch),
        spline_total(order_, x.width) * spline_total(order_, y.width));
  }
  const int index = level_for(x, y, made.longest);
  const Pyramid::Level& size = pyramid_.level(index);
  const auto scaled = [](const SplineInterval& interval, int texels, int finest_texels) {
    const double scale = static_cast<double>(texels) / finest_texels;
    return SplineInterval{scale * interval.left, scale * interval.width};
  };
  x = scaled(x, size.width, finest.width);
  y = scaled(y, size.height, finest.height);
  cut_into_pieces(x, order_, size.width, wrap_, made.longest, scratch.across);
  cut_into_pieces(y, order_, size.height, wrap_, made.longest, scratch.down);
  const IntegralTable& table = *made.levels[static_cast<std::size_t>(index)];
  table.carries();
  for (const AxisPiece& down : scratch.down) {
    for (const AxisPiece& across : scratch.across) {
      add_block(table, order_, across, down, scratch.tables, words);
    }
  }
  return color_of(words, spline_total(order_, x.width) * spline_total(order_, y.width));
}

std::size_t RepeatedIntegration::bytes() const {
  std::size_t bytes = 0;
  for (const auto& level : tables_.levels) bytes += level->bytes();
  return bytes;
}

}  // namespace sweepkit::texmap
