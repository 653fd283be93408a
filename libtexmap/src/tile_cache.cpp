// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A clock [Corbato68]: the hand goes round the tiles, takes a life from each that nobody has read since, and
// drops those that have none left. Departs from the textbook in giving a tile as many lives as its level is
// high: a coarse tile is made from four finer ones, and those from four each.

#include "sweepkit/texmap/tile_cache.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <mutex>

namespace sweepkit::texmap {

std::size_t TileMemory::slot_bytes(std::size_t bytes) {
  constexpr std::size_t kLeast = 64;  // a line of the processor's cache
  constexpr std::size_t kStep = std::size_t{1} << 14;
  return bytes <= 2 * kStep ? std::bit_ceil(std::max(bytes, kLeast)) : (bytes + kStep - 1) / kStep * kStep;
}

std::byte* TileMemory::take(std::size_t slot) {
  std::vector<FreeSlot>& free = free_[slot];
  if (free.empty()) {
    // Not touched, and so not in memory, before a tile is written to it.
    std::byte* block = blocks_
                           .emplace_back(static_cast<std::byte*>(
                               ::operator new (std::max(kBlock, slot), std::align_val_t{kPage})))
                           .get();
    for (std::size_t at = std::max(kBlock / slot, std::size_t{1}); at-- > 0;)
      free.push_back({block + at * slot, false});
  }
  const FreeSlot taken = free.back();
  free.pop_back();
  if (taken.is_in_memory) spare_ -= slot;
  return taken.memory;
}

void TileMemory::give_back(std::byte* memory, std::size_t slot) {
  const bool stays = slot % kPage != 0 || spare_ + slot <= kMostSpare;
  if (stays) {
    spare_ += slot;
  } else {
    ::madvise(memory, slot, MADV_DONTNEED);
  }
  free_[slot].push_back({memory, stays});
}

const Tile* TileCache::pin(const TileKey& key, const TileMaker& maker) {
  const std::uint64_t packed = key.packed();
  const int lives = 1 + 2 * static_cast<int>(key.level % TileKey::kFirstTable);
  const auto take = [&](Tile& tile) {
    tile.pins_.fetch_add(1, std::memory_order_relaxed);
    tile.lives_.store(lives, std::memory_order_relaxed);
    return &tile;
  };
  {
    const std::shared_lock lock(mutex_);
    if (const auto found = tiles_.find(packed); found != tiles_.end()) return take(*found->second);
  }
  std::unique_ptr<Tile> made = make_tile(key, maker);
  const std::unique_lock lock(mutex_);
  // Another thread may have been first; its tile holds the same bytes.
  const auto [place, is_new] = tiles_.try_emplace(packed, std::move(made));
  Tile* tile = take(*place->second);
  if (is_new) {
    clock_.push_back(tile);
    ++counts_.made;
    counts_.bytes += tile->bytes_;
    drop_to_bound();
    counts_.peak_bytes = std::max(counts_.peak_bytes, counts_.bytes);
  } else {
    memory_.give_back(made->data_, made->bytes_);
  }
  return tile;
}

std::unique_ptr<Tile> TileCache::make_tile(const TileKey& key, const TileMaker& maker) {
  auto tile = std::make_unique<Tile>();
  tile->key_ = key.packed();
  tile->bytes_ = TileMemory::slot_bytes(maker.tile_bytes(key));
  {
    const std::unique_lock lock(mutex_);
    tile->data_ = memory_.take(tile->bytes_);
  }
  try {
    maker.make(key, tile->data_);
  } catch (...) {
    const std::unique_lock lock(mutex_);
    memory_.give_back(tile->data_, tile->bytes_);
    throw;
  }
  return tile;
}

void TileCache::drop_to_bound() {
  // No tile outlives more rounds than its lives; after those, all that is left is pinned.
  constexpr std::size_t kRounds = 2 + 2 * 31;
  std::size_t steps = kRounds * clock_.size();
  while (counts_.bytes > bound_ - held_ && steps-- > 0 && !clock_.empty()) {
    if (hand_ >= clock_.size()) hand_ = 0;
    Tile* tile = clock_[hand_];
    if (tile->pins_.load(std::memory_order_acquire) > 0 ||
        tile->lives_.fetch_sub(1, std::memory_order_relaxed) > 0) {
      ++hand_;
    } else {
      counts_.bytes -= tile->bytes_;
      ++counts_.dropped;
      memory_.give_back(tile->data_, tile->bytes_);
      clock_[hand_] = clock_.back();
      clock_.pop_back();
      tiles_.erase(tile->key_);
    }
  }
}

bool TileCache::hold(std::size_t bytes) {
  const std::unique_lock lock(mutex_);
  if (held_ + bytes > bound_ / 4) return false;
  held_ += bytes;
  drop_to_bound();
  return true;
}

void TileCache::let_go(std::size_t bytes) {
  const std::unique_lock lock(mutex_);
  held_ -= bytes;
}

TileCache::Counts TileCache::counts() const {
  const std::shared_lock lock(mutex_);
  return counts_;
}

void TileReader::replace(Slot& slot, const TileKey& key, const TileMaker& maker) {
  const Tile* tile = cache_->pin(key, maker);
  if (slot.tile != nullptr) TileCache::unpin(slot.tile);
  slot = {key.packed(), tile->data(), tile};
}

void TileReader::release() {
  for (Slot& slot : slots_) {
    if (slot.tile != nullptr) TileCache::unpin(slot.tile);
    slot = {};
  }
}

}  // namespace sweepkit::texmap
