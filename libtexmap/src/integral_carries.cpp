// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A table of n-fold sums is 24 bytes a texel, and most of it is never looked at. A tile of it can be made
// from its own texels and the sums at its left and upper edge; these are kept, the tiles come and go. Words
// are unsigned and may wrap round.

#include "integral_carries.hpp"

#include <algorithm>

namespace sweepkit::texmap {
namespace {

std::size_t words_of(int a, int b) {
  return 3 * static_cast<std::size_t>(a) * static_cast<std::size_t>(b);
}

}  // namespace

IntegralCarries::IntegralCarries(const Pyramid& pyramid, int level, int order, const FixedPoint& fixed_point,
                                 TileCache& cache)
    : cache_(cache), order_(order), width_(pyramid.level(level).width) {
  const int tiles = (width_ + kTileSide - 1) / kTileSide;
  above_words_ = words_of(order, width_);
  beside_words_ = words_of(order, tiles * kTileSide);
  const int bands = (pyramid.level(level).height + kTileSide - 1) / kTileSide;
  const std::size_t words = static_cast<std::size_t>(bands) * band_words();
  if (cache_.hold(words * sizeof(std::uint64_t))) {
    held_ = words * sizeof(std::uint64_t);
    in_memory_.reserve(words);
  } else {
    file_.emplace("the sums of a texture of " + std::to_string(width_) + " x " +
                  std::to_string(pyramid.level(level).height) + " texels");
  }
  const auto sum_up_as = [&]<class Texel>(Texel /*form*/) {
    if (order == 1) sum_up<1, Texel>(pyramid, level, fixed_point);
    if (order == 2) sum_up<2, Texel>(pyramid, level, fixed_point);
    if (order == 3) sum_up<3, Texel>(pyramid, level, fixed_point);
  };
  try {
    if (pyramid.is_float()) {
      sum_up_as(FloatTexel{});
    } else {
      sum_up_as(IntegerTexel{});
    }
  } catch (...) {
    cache_.let_go(held_);
    throw;
  }
}

IntegralCarries::~IntegralCarries() {
  cache_.let_go(held_);
}

template <int order, class Texel>
void IntegralCarries::sum_up(const Pyramid& pyramid, int level, const FixedPoint& fixed_point) {
  const auto width = static_cast<std::size_t>(width_);
  const int height = pyramid.level(level).height;
  std::vector<std::uint64_t> above(above_words_);
  std::vector<std::uint64_t> beside(beside_words_);
  std::vector<std::uint64_t> row(3 * width);
  for (int top = 0; top < height; top += kTileSide) {
    append(above);
    const int rows = std::min(kTileSide, height - top);
    const std::vector<Texel> texels = pyramid.read<Texel>(level, {0, top, width_, rows});
    for (int y = 0; y < rows; ++y) {
      const Texel* texel = texels.data() + static_cast<std::size_t>(y) * width;
      std::array<std::array<std::uint64_t, 3>, order> sums{};
      for (std::size_t x = 0; x < width; ++x) {
        if (x % kTileSide == 0) {
          std::uint64_t* to = beside.data() + 3 * order * (x + static_cast<std::size_t>(y));
          for (const auto& sum : sums) to = std::copy(sum.begin(), sum.end(), to);
        }
        for (std::size_t k = 0; k < 3; ++k) {
          std::uint64_t carry = fixed_point.word(texel[x], k);
          for (auto& sum : sums) carry = sum[k] += carry;
          row[3 * x + k] = carry;
        }
      }
      for (std::size_t k = 0; k < 3; ++k) total_[k] += sums[0][k];
      for (std::size_t at = 0; at < 3 * width; ++at) {
        std::uint64_t carry = row[at];
        for (std::size_t m = 0; m < order; ++m) carry = above[m * 3 * width + at] += carry;
      }
    }
    append(beside);
  }
}

void IntegralCarries::append(std::span<const std::uint64_t> words) {
  if (file_) {
    file_->append(std::as_bytes(words));
  } else {
    in_memory_.insert(in_memory_.end(), words.begin(), words.end());
  }
}

void IntegralCarries::read(std::size_t first, std::span<std::uint64_t> words) const {
  if (file_) {
    file_->read(static_cast<std::int64_t>(first * sizeof(std::uint64_t)), std::as_writable_bytes(words));
  } else {
    std::copy_n(in_memory_.begin() + static_cast<std::ptrdiff_t>(first), words.size(), words.begin());
  }
}

void IntegralCarries::read_beside(int tile_column, int tile_row, std::span<std::uint64_t> words) const {
  read(static_cast<std::size_t>(tile_row) * band_words() + above_words_ +
           words_of(order_, tile_column * kTileSide),
       words);
}

void IntegralCarries::read_above(int first, int tile_row, std::span<std::uint64_t> words) const {
  const std::size_t part = words.size() / static_cast<std::size_t>(order_);
  for (int m = 0; m < order_; ++m) {
    read(static_cast<std::size_t>(tile_row) * band_words() + words_of(m, width_) + words_of(first, 1),
         words.subspan(static_cast<std::size_t>(m) * part, part));
  }
}

}  // namespace sweepkit::texmap
