// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>

#include "fixed_point.hpp"
#include "integral_carries.hpp"
#include "pyramid.hpp"
#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::texmap {

/// The n-fold sums, along both axes, of the texels of one level of a texture [Crow84, Heckbert86], RGB, in
/// 64-bit words that wrap round; in tiles that are made when they are first read. The entry of texel (x, y)
/// sums the texels left of and above its lower right corner, itself among them; there is none for the zeros
/// along the left and the upper edge.
class IntegralTable : public TileMaker {
 public:
  IntegralTable(const Pyramid& pyramid, int level, int order, const FixedPoint& fixed_point, TileCache& cache,
                std::uint32_t id);

  /// Sums up the image, unless that is done: before the first tile is read. Throws as IntegralCarries does.
  const IntegralCarries& carries() const;

  /// Memory held besides tiles.
  std::size_t bytes() const { return carries_ ? carries_->bytes() : 0; }

  /// The first entry of a tile: 3 words a texel, kTileSide texels a row. Good until the reader's next read.
  const std::uint64_t* tile(TileReader& reader, int column, int row) const {
    return reinterpret_cast<const std::uint64_t*>(
        reader.read({id_, TileKey::kFirstTable + static_cast<std::uint32_t>(level_),
                     static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)},
                    *this));
  }

  std::size_t tile_bytes(const TileKey& key) const override;
  void make(const TileKey& key, std::byte* words) const override;

 private:
  int rows_of(const TileKey& key) const;
  template <int order, class Texel>
  void make_of(const TileKey& key, std::uint64_t* words) const;

  const Pyramid& pyramid_;
  int level_;
  int order_;
  FixedPoint fixed_point_;
  TileCache& cache_;
  std::uint32_t id_;
  mutable std::once_flag once_;
  mutable std::optional<IntegralCarries> carries_;
};

}  // namespace sweepkit::texmap
