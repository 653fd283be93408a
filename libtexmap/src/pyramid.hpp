// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "sweepkit/texmap/tile_cache.hpp"
#include "texel_source.hpp"

namespace sweepkit::texmap {

/// Texels along a tile's side: a tile of integer texels is 32 KiB. Those at the lower border of a level have
/// as few rows as there are.
inline constexpr int kTileSide = 64;

/// A texture at every size from its own down to one texel, each half the one before (rounded down, each texel
/// the mean of the area it stands for) [Williams83], in tiles that are made when they are first read.
class Pyramid : public TileMaker {
 public:
  struct Level {
    int width;
    int height;
    glm::dvec2 scale{1.0};  ///< its texels to one of the finest level, along each axis
  };

  /// `id` sets the texture apart from others in the same cache.
  Pyramid(std::shared_ptr<const TexelSource> source, TileCache& cache, std::uint32_t id);

  bool is_float() const { return source_->is_float(); }
  int level_count() const { return static_cast<int>(levels_.size()); }
  const Level& level(int index) const { return levels_[static_cast<std::size_t>(index)]; }

  /// The first texel of a tile whose rows are kTileSide apart; good until the reader's next read. `Texel` is
  /// the form that is_float() names.
  template <class Texel>
  const Texel* tile(TileReader& reader, int level, int column, int row) const {
    return reinterpret_cast<const Texel*>(
        reader.read({id_, static_cast<std::uint32_t>(level), static_cast<std::uint32_t>(column),
                     static_cast<std::uint32_t>(row)},
                    *this));
  }

  /// Texels of a level, row by row; the finest straight from the image, others from their tiles.
  template <class Texel>
  std::vector<Texel> read(int level, const PixelRect& rect) const;

  std::size_t tile_bytes(const TileKey& key) const override;
  void make(const TileKey& key, std::byte* texels) const override;

 private:
  template <class Texel>
  void read(int level, const PixelRect& rect, std::span<Texel> region) const;
  template <class Texel>
  void make_of(const TileKey& key, Texel* texels) const;

  std::shared_ptr<const TexelSource> source_;
  TileCache& cache_;
  std::uint32_t id_;
  std::vector<Level> levels_;
};

}  // namespace sweepkit::texmap
