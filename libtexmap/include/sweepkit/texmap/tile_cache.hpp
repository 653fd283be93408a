// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <new>
#include <shared_mutex>
#include <unordered_map>
#include <vector>

#include "sweepkit/texmap/texture_memory.hpp"

namespace sweepkit::texmap {

/// Which tile of which level of which texture.
struct TileKey {
  std::uint32_t texture = 0;  ///< up to 65535
  std::uint32_t level = 0;    ///< up to 31 of texels, and as many of tables after kFirstTable
  std::uint32_t column = 0;   ///< in tiles, up to 2^21 - 1
  std::uint32_t row = 0;

  static constexpr std::uint32_t kFirstTable = 32;

  std::uint64_t packed() const {
    return std::uint64_t{texture} << 48 | std::uint64_t{level} << 42 | std::uint64_t{row} << 21 | column;
  }
};

/// Memory of one tile; what is in it never changes once it is in the cache.
class Tile {
 public:
  const std::byte* data() const { return data_; }

 private:
  friend class TileCache;
  std::byte* data_ = nullptr;
  std::size_t bytes_ = 0;
  std::uint64_t key_ = 0;
  std::atomic<int> pins_{0};   // who reads it now
  std::atomic<int> lives_{0};  // rounds of the clock that it outlives unread
};

/// Makes a tile's texels. The same key always gives the same bytes, so that it does not matter who makes a
/// tile, or how often.
class TileMaker {
 public:
  virtual ~TileMaker() = default;
  virtual std::size_t tile_bytes(const TileKey& key) const = 0;  ///< up to kLargestTile
  virtual void make(const TileKey& key, std::byte* texels) const = 0;

  static constexpr std::size_t kLargestTile = std::size_t{1} << 17;
};

/// Memory for tiles, in slots cut from blocks that are kept until the end: tiles come and go by the hundred
/// thousand, and a general heap would be left full of holes. A free slot serves its own size alone; past a
/// few, the pages of free slots go back to the system, so that what is in use decides what memory is taken.
class TileMemory {
 public:
  static constexpr std::size_t kMostSpare = std::size_t{4}
                                            << 20;  ///< bytes of free slots that stay in memory

  /// Bytes that a tile of this size takes.
  static std::size_t slot_bytes(std::size_t bytes);
  std::byte* take(std::size_t slot);
  void give_back(std::byte* memory, std::size_t slot);

 private:
  static constexpr std::size_t kPage = 4096;
  static constexpr std::size_t kBlock = std::size_t{1} << 20;
  struct Free {
    void operator()(std::byte* block) const { ::operator delete (block, std::align_val_t{kPage}); }
  };
  struct FreeSlot {
    std::byte* memory;
    bool is_in_memory;
  };
  std::vector<std::unique_ptr<std::byte, Free>> blocks_;
  std::map<std::size_t, std::vector<FreeSlot>> free_;  // by the slot's size
  std::size_t spare_ = 0;                              // of free slots that are in memory
};

/// Tiles of all textures, made when first touched and dropped when they come to more than the bound. Who
/// reads a tile pins it; pinned tiles are not dropped, so the bound may be passed by what the readers hold
/// (TileReader) and by the tiles being made. Any number of threads.
class TileCache {
 public:
  explicit TileCache(std::size_t bound = kDefaultTextureMemory) : bound_(bound) {}

  TileCache(const TileCache&) = delete;
  TileCache& operator=(const TileCache&) = delete;

  /// The tile, pinned; unpin() it when done. `maker` is asked without any lock held, possibly by several
  /// threads at once; what it throws passes through.
  const Tile* pin(const TileKey& key, const TileMaker& maker);
  static void unpin(const Tile* tile) {
    const_cast<Tile*>(tile)->pins_.fetch_sub(1, std::memory_order_release);
  }

  /// Takes memory that holds no tiles, but belongs to textures as they do, off the bound. False if all that
  /// is so held would come to more than a quarter of it: then nothing is taken.
  bool hold(std::size_t bytes);
  void let_go(std::size_t bytes);

  struct Counts {
    std::uint64_t made = 0;
    std::uint64_t dropped = 0;
    std::size_t bytes = 0;
    std::size_t peak_bytes = 0;
  };
  Counts counts() const;

 private:
  std::unique_ptr<Tile> make_tile(const TileKey& key, const TileMaker& maker);
  void drop_to_bound();

  std::size_t bound_;
  std::size_t held_ = 0;
  mutable std::shared_mutex mutex_;
  TileMemory memory_;
  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;
  std::vector<Tile*> clock_;
  std::size_t hand_ = 0;
  Counts counts_;
};

/// One thread's way to the tiles: keeps those it read last pinned, so that most lookups take no lock.
class TileReader {
 public:
  /// Keeps up to `slots` tiles, a power of two.
  TileReader(TileCache& cache, std::size_t slots) : cache_(&cache), slots_(slots) {}
  ~TileReader() { release(); }
  TileReader(const TileReader&) = delete;
  TileReader& operator=(const TileReader&) = delete;

  /// The tile's bytes; good until the next call.
  const std::byte* read(const TileKey& key, const TileMaker& maker) {
    const std::uint64_t packed = key.packed();
    Slot& slot = slots_[(packed ^ packed >> 18 ^ packed >> 40) & (slots_.size() - 1)];
    if (slot.tile == nullptr || slot.key != packed) replace(slot, key, maker);
    return slot.data;
  }
  void release();

 private:
  struct Slot {
    std::uint64_t key = 0;
    const std::byte* data = nullptr;
    const Tile* tile = nullptr;
  };
  void replace(Slot& slot, const TileKey& key, const TileMaker& maker);

  TileCache* cache_;
  std::vector<Slot> slots_;
};

}  // namespace sweepkit::texmap
