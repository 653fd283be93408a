// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <shared_mutex>
#include <unordered_map>
#include <vector>

#include "sweepkit/texmap/texture_memory.hpp"

namespace sweepkit::texmap {

/// Which tile of which level of which texture.
struct TileKey {
  std::uint32_t texture = 0;  ///< up to 65535
  std::uint32_t level = 0;    ///< up to 31
  std::uint32_t column = 0;   ///< in tiles, up to 2^21 - 1
  std::uint32_t row = 0;

  std::uint64_t packed() const {
    return std::uint64_t{texture} << 48 | std::uint64_t{level} << 42 | std::uint64_t{row} << 21 | column;
  }
};

/// Memory of one tile; what is in it never changes once it is in the cache.
class Tile {
 public:
  explicit Tile(std::size_t bytes) : texels_(bytes / sizeof(Block) + 1) {}

  std::byte* data() { return reinterpret_cast<std::byte*>(texels_.data()); }
  const std::byte* data() const { return reinterpret_cast<const std::byte*>(texels_.data()); }
  std::size_t bytes() const { return texels_.size() * sizeof(Block); }

 private:
  friend class TileCache;
  struct alignas(16) Block {
    std::array<std::byte, 16> bytes;
  };
  std::vector<Block> texels_;
  std::uint64_t key_ = 0;
  std::atomic<int> pins_{0};   // who reads it now
  std::atomic<int> lives_{0};  // rounds of the clock that it outlives unread
};

/// Makes a tile's texels. The same key always gives the same bytes, so that it does not matter who makes a
/// tile, or how often.
class TileMaker {
 public:
  virtual ~TileMaker() = default;
  virtual std::unique_ptr<Tile> make(const TileKey& key) const = 0;
};

/// Tiles of all textures, made when first touched and dropped when they come to more than the bound. Who
/// reads a tile pins it; pinned tiles are not dropped, so the bound may be passed by what the readers hold
/// (TileReader: 128 tiles each) and by the tiles being made. Any number of threads.
class TileCache {
 public:
  explicit TileCache(std::size_t bound = kDefaultTextureMemory) : bound_(bound) {}

  /// The tile, pinned; unpin() it when done. `maker` is asked without any lock held, possibly by several
  /// threads at once; what it throws passes through.
  const Tile* pin(const TileKey& key, const TileMaker& maker);
  static void unpin(const Tile* tile) {
    const_cast<Tile*>(tile)->pins_.fetch_sub(1, std::memory_order_release);
  }

  struct Counts {
    std::uint64_t made = 0;
    std::uint64_t dropped = 0;
    std::size_t bytes = 0;
    std::size_t peak_bytes = 0;
  };
  Counts counts() const;

 private:
  void drop_to_bound();

  std::size_t bound_;
  mutable std::shared_mutex mutex_;
  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;
  std::vector<Tile*> clock_;
  std::size_t hand_ = 0;
  Counts counts_;
};

/// One thread's way to the tiles: keeps those it read last pinned, so that most lookups take no lock.
class TileReader {
 public:
  explicit TileReader(TileCache& cache) : cache_(&cache) {}
  ~TileReader() { release(); }
  TileReader(const TileReader&) = delete;
  TileReader& operator=(const TileReader&) = delete;

  /// The tile's bytes; good until the next call.
  const std::byte* read(const TileKey& key, const TileMaker& maker) {
    const std::uint64_t packed = key.packed();
    Slot& slot = slots_[(packed ^ packed >> 18 ^ packed >> 40) % kSlots];
    if (slot.tile == nullptr || slot.key != packed) replace(slot, key, maker);
    return slot.data;
  }
  void release();

 private:
  static constexpr std::size_t kSlots = 128;
  struct Slot {
    std::uint64_t key = 0;
    const std::byte* data = nullptr;
    const Tile* tile = nullptr;
  };
  void replace(Slot& slot, const TileKey& key, const TileMaker& maker);

  TileCache* cache_;
  std::array<Slot, kSlots> slots_{};
};

}  // namespace sweepkit::texmap
