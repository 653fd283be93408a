// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fixed_point.hpp"
#include "pyramid.hpp"
#include "temporary_file.hpp"

namespace sweepkit::texmap {

/// What the tiles of a table of n-fold sums need to know of the texels left of and above each of them, summed
/// up in one pass over the image, a band of tiles at a time. It takes 3 n bytes / 4 a texel: in memory up to
/// a share of the tile cache's bound, else in a temporary file. Any number of threads read.
class IntegralCarries {
 public:
  /// Throws what reading the texels throws, and OutputError if the temporary file cannot be written.
  IntegralCarries(const Pyramid& pyramid, int level, int order, const FixedPoint& fixed_point,
                  TileCache& cache);
  ~IntegralCarries();
  IntegralCarries(const IntegralCarries&) = delete;
  IntegralCarries& operator=(const IntegralCarries&) = delete;

  /// For each of the kTileSide rows of a tile the 1-fold .. n-fold sums of the row's texels left of the tile:
  /// kTileSide x n x 3 words.
  void read_beside(int tile_column, int tile_row, std::span<std::uint64_t> words) const;
  /// The 1-fold .. n-fold sums, down to a row of tiles, of what n-fold sums along the rows above it make of
  /// columns first + 1, first + 2, ...: n x (words / n / 3) x 3 words.
  void read_above(int first, int tile_row, std::span<std::uint64_t> words) const;

  /// The sum of all texels.
  const std::array<std::uint64_t, 3>& total() const { return total_; }
  std::size_t bytes() const { return in_memory_.size() * sizeof(std::uint64_t); }

 private:
  template <int order, class Texel>
  void sum_up(const Pyramid& pyramid, int level, const FixedPoint& fixed_point);
  void append(std::span<const std::uint64_t> words);
  void read(std::size_t first, std::span<std::uint64_t> words) const;
  std::size_t band_words() const { return above_words_ + beside_words_; }

  TileCache& cache_;
  int order_;
  int width_;
  std::size_t above_words_;   // of a band: n x width x 3
  std::size_t beside_words_;  // then: tiles x kTileSide x n x 3
  std::vector<std::uint64_t> in_memory_;
  std::size_t held_ = 0;
  std::optional<TemporaryFile> file_;
  std::array<std::uint64_t, 3> total_{};
};

}  // namespace sweepkit::texmap
