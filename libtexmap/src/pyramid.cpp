// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Williams83]. Departs from it where a size is odd: a texel of the next level is the mean of
// exactly the area it stands for, of two whole texels and parts of a third, instead of leaving the last one
// out; so a level's mean is the texture's mean, and nothing shifts.

#include "pyramid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace sweepkit::texmap {
namespace {

// The texels of a finer axis that one of the next level stands for, and their shares. At most three and a
// bit: 2 <= from / to <= 3.
struct Share {
  int first = 0;
  int count = 0;
  double weights[4] = {};
};

Share share_of(int index, int from, int to) {
  const double width = static_cast<double>(from) / to;
  // As whole numbers over `to`, so that no rounding moves an edge that lies between two texels.
  const std::int64_t begin = std::int64_t{index} * from;
  const std::int64_t end = begin + from;
  Share share;
  share.first = static_cast<int>(begin / to);
  for (std::int64_t texel = share.first; texel * to < end; ++texel) {
    const std::int64_t covered = std::min(end, (texel + 1) * to) - std::max(begin, texel * to);
    share.weights[share.count++] = static_cast<double>(covered) / to / width;
  }
  return share;
}

IntegerTexel to_texel(const double (&sum)[3], IntegerTexel /*form*/) {
  const auto rounded = [](double value) { return static_cast<std::uint16_t>(std::lround(value)); };
  return IntegerTexel{rounded(sum[0]), rounded(sum[1]), rounded(sum[2]), 65535};
}
FloatTexel to_texel(const double (&sum)[3], FloatTexel /*form*/) {
  return FloatTexel{static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2]), 1.0f};
}

// The common case, a size that halves evenly. Rounds as to_texel() does. Two of the four numbers at a time,
// each with 16 bits of its own above it for the carry.
IntegerTexel mean_of(IntegerTexel a, IntegerTexel b, IntegerTexel c, IntegerTexel d) {
  constexpr std::uint64_t kEven = 0x0000ffff0000ffff;
  constexpr std::uint64_t kHalf = 0x0000000200000002;  // of the four that are summed
  const auto even = [](IntegerTexel texel) { return std::bit_cast<std::uint64_t>(texel) & kEven; };
  const auto odd = [](IntegerTexel texel) { return std::bit_cast<std::uint64_t>(texel) >> 16 & kEven; };
  const std::uint64_t evens = ((even(a) + even(b) + even(c) + even(d) + kHalf) >> 2) & kEven;
  const std::uint64_t odds = ((odd(a) + odd(b) + odd(c) + odd(d) + kHalf) >> 2) & kEven;
  return std::bit_cast<IntegerTexel>(evens | odds << 16);
}
FloatTexel mean_of(FloatTexel a, FloatTexel b, FloatTexel c, FloatTexel d) {
  return 0.25f * ((a + b) + (c + d));
}

}  // namespace

Pyramid::Pyramid(std::shared_ptr<const TexelSource> source, TileCache& cache, std::uint32_t id)
    : source_(std::move(source)), cache_(cache), id_(id) {
  levels_.push_back({source_->width(), source_->height()});
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const int width = std::max(1, levels_.back().width / 2);
    const int height = std::max(1, levels_.back().height / 2);
    levels_.push_back(
        {width, height, glm::dvec2(width, height) / glm::dvec2(levels_[0].width, levels_[0].height)});
  }
}

std::size_t Pyramid::tile_bytes(const TileKey& key) const {
  const int height = std::min(kTileSide, levels_[key.level].height - static_cast<int>(key.row) * kTileSide);
  return (is_float() ? sizeof(FloatTexel) : sizeof(IntegerTexel)) * kTileSide *
         static_cast<std::size_t>(height);
}

void Pyramid::make(const TileKey& key, std::byte* texels) const {
  if (is_float()) {
    make_of(key, reinterpret_cast<FloatTexel*>(texels));
  } else {
    make_of(key, reinterpret_cast<IntegerTexel*>(texels));
  }
}

template <class Texel>
void Pyramid::make_of(const TileKey& key, Texel* texels) const {
  const Level& size = levels_[key.level];
  const int x0 = static_cast<int>(key.column) * kTileSide;
  const int y0 = static_cast<int>(key.row) * kTileSide;
  const int width = std::min(kTileSide, size.width - x0);
  const int height = std::min(kTileSide, size.height - y0);
  if (key.level == 0) {
    if (width == kTileSide)
      return source_->read({x0, y0, width, height}, std::span(texels, static_cast<std::size_t>(width) *
                                                                          static_cast<std::size_t>(height)));
    const std::vector<Texel> region = read<Texel>(0, {x0, y0, width, height});
    for (int y = 0; y < height; ++y) std::copy_n(region.begin() + y * width, width, texels + y * kTileSide);
    return;
  }
  const int below = static_cast<int>(key.level) - 1;
  const Level& finer = level(below);
  if (finer.width == 2 * size.width && finer.height == 2 * size.height) {
    // A few rows at a time, so that they stay in the processor's first cache.
    constexpr int kRows = 8;
    std::vector<Texel> region(static_cast<std::size_t>(2 * kRows) * static_cast<std::size_t>(2 * width));
    for (int top = 0; top < height; top += kRows) {
      const int rows = std::min(kRows, height - top);
      const PixelRect rect{2 * x0, 2 * (y0 + top), 2 * width, 2 * rows};
      read<Texel>(below, rect,
                  std::span(region).first(std::size_t{4} * static_cast<std::size_t>(rows) *
                                          static_cast<std::size_t>(width)));
      const Texel* upper = region.data();
      for (int y = top; y < top + rows; ++y, upper += 4 * width) {
        const Texel* lower = upper + 2 * width;
        for (int x = 0; x < width; ++x)
          texels[y * kTileSide + x] = mean_of(upper[2 * x], upper[2 * x + 1], lower[2 * x], lower[2 * x + 1]);
      }
    }
    return;
  }
  std::vector<Share> across;
  std::vector<Share> down;
  across.reserve(static_cast<std::size_t>(width));
  down.reserve(static_cast<std::size_t>(height));
  for (int x = 0; x < width; ++x) across.push_back(share_of(x0 + x, finer.width, size.width));
  for (int y = 0; y < height; ++y) down.push_back(share_of(y0 + y, finer.height, size.height));
  const PixelRect rect{across.front().first, down.front().first,
                       across.back().first + across.back().count - across.front().first,
                       down.back().first + down.back().count - down.front().first};
  const std::vector<Texel> region = read<Texel>(below, rect);
  for (int y = 0; y < height; ++y) {
    const Share& rows = down[static_cast<std::size_t>(y)];
    for (int x = 0; x < width; ++x) {
      const Share& columns = across[static_cast<std::size_t>(x)];
      double sum[3] = {};
      for (int j = 0; j < rows.count; ++j) {
        const Texel* row = region.data() + (rows.first + j - rect.y) * rect.width + (columns.first - rect.x);
        for (int i = 0; i < columns.count; ++i) {
          const double weight = rows.weights[j] * columns.weights[i];
          for (int k = 0; k < 3; ++k) sum[k] += weight * static_cast<double>(row[i][k]);
        }
      }
      texels[y * kTileSide + x] = to_texel(sum, Texel{});
    }
  }
}

template <class Texel>
std::vector<Texel> Pyramid::read(int level, const PixelRect& rect) const {
  std::vector<Texel> region(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height));
  read<Texel>(level, rect, region);
  return region;
}

// The finest level straight from the source: a tile of it is made once, by whoever reads it itself.
template <class Texel>
void Pyramid::read(int level, const PixelRect& rect, std::span<Texel> region) const {
  if (level == 0) return source_->read(rect, region);
  const int x_end = rect.x + rect.width;
  const int y_end = rect.y + rect.height;
  for (int row = rect.y / kTileSide; row * kTileSide < y_end; ++row) {
    for (int column = rect.x / kTileSide; column * kTileSide < x_end; ++column) {
      const Tile* tile = cache_.pin({id_, static_cast<std::uint32_t>(level),
                                     static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)},
                                    *this);
      const auto* texels = reinterpret_cast<const Texel*>(tile->data());
      const int x0 = std::max(rect.x, column * kTileSide);
      const int x1 = std::min(x_end, (column + 1) * kTileSide);
      for (int y = std::max(rect.y, row * kTileSide); y < std::min(y_end, (row + 1) * kTileSide); ++y) {
        std::copy(texels + (y - row * kTileSide) * kTileSide + (x0 - column * kTileSide),
                  texels + (y - row * kTileSide) * kTileSide + (x1 - column * kTileSide),
                  region.begin() + (y - rect.y) * rect.width + (x0 - rect.x));
      }
      TileCache::unpin(tile);
    }
  }
}

template std::vector<IntegerTexel> Pyramid::read(int level, const PixelRect& rect) const;
template std::vector<FloatTexel> Pyramid::read(int level, const PixelRect& rect) const;

}  // namespace sweepkit::texmap
