// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "integral_table.hpp"

#include "sweepkit/strict_math.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace sweepkit::texmap {

IntegralTable::IntegralTable(const Pyramid& pyramid, int level, int order, const FixedPoint& fixed_point,
                             TileCache& cache, std::uint32_t id)
    : pyramid_(pyramid), level_(level), order_(order), fixed_point_(fixed_point), cache_(cache), id_(id) {}

const IntegralCarries& IntegralTable::carries() const {
  std::call_once(once_, [&] { carries_.emplace(pyramid_, level_, order_, fixed_point_, cache_); });
  return *carries_;
}

int IntegralTable::rows_of(const TileKey& key) const {
  return std::min(kTileSide, pyramid_.level(level_).height - static_cast<int>(key.row) * kTileSide);
}

std::size_t IntegralTable::tile_bytes(const TileKey& key) const {
  return 3 * sizeof(std::uint64_t) * kTileSide * static_cast<std::size_t>(rows_of(key));
}

void IntegralTable::make(const TileKey& key, std::byte* bytes) const {
  auto* words = reinterpret_cast<std::uint64_t*>(bytes);
  const auto make_as = [&]<class Texel>(Texel /*form*/) {
    if (order_ == 1) make_of<1, Texel>(key, words);
    if (order_ == 2) make_of<2, Texel>(key, words);
    if (order_ == 3) make_of<3, Texel>(key, words);
  };
  if (pyramid_.is_float()) {
    make_as(FloatTexel{});
  } else {
    make_as(IntegerTexel{});
  }
}

// As IntegralCarries sums up a band, from where that stood at the tile's edges.
template <int order, class Texel>
void IntegralTable::make_of(const TileKey& key, std::uint64_t* words) const {
  const auto tile_column = static_cast<int>(key.column);
  const auto tile_row = static_cast<int>(key.row);
  const int left = tile_column * kTileSide;
  const int width = std::min(kTileSide, pyramid_.level(level_).width - left);
  const int rows = rows_of(key);
  const auto row_words = 3 * static_cast<std::size_t>(width);
  std::vector<std::uint64_t> above(order * row_words);
  std::array<std::array<std::array<std::uint64_t, 3>, order>, kTileSide> beside;
  carries_->read_above(left, tile_row, above);
  carries_->read_beside(tile_column, tile_row, {beside.front().front().data(), 3 * order * kTileSide});
  const std::vector<Texel> texels = pyramid_.read<Texel>(level_, {left, tile_row * kTileSide, width, rows});
  const Texel* texel = texels.data();
  for (int y = 0; y < rows; ++y, words += 3 * kTileSide) {
    auto& sums = beside[static_cast<std::size_t>(y)];
    for (std::size_t at = 0; at < row_words; at += 3, ++texel) {
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint64_t carry = fixed_point_.word(*texel, k);
        for (auto& sum : sums) carry = sum[k] += carry;
        for (std::size_t m = 0; m < order; ++m) carry = above[m * row_words + at + k] += carry;
        words[at + k] = carry;
      }
    }
  }
}

}  // namespace sweepkit::texmap
