// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::texmap {
namespace {

// Of these slots, the bytes whose pages are in memory.
std::size_t bytes_in_memory(const std::set<std::byte*>& slots, std::size_t slot) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  std::vector<unsigned char> pages(slot / page);
  std::size_t count = 0;
  for (std::byte* first : slots) {
    EXPECT_EQ(mincore(first, slot, pages.data()), 0);
    for (const unsigned char state : pages) count += state & 1;
  }
  return count * page;
}

std::vector<std::byte*> take_and_fill(TileMemory& memory, std::size_t slot, std::size_t count) {
  std::vector<std::byte*> taken;
  for (std::size_t i = 0; i < count; ++i) {
    taken.push_back(memory.take(slot));
    std::fill_n(taken.back(), slot, std::byte{1});
  }
  return taken;
}

constexpr std::size_t kTexels = std::size_t{32} << 10;
constexpr std::size_t kTable = std::size_t{96} << 10;
constexpr std::size_t kAll = std::size_t{96} << 20;

TEST(TileMemory, TakesNoMoreThanIsInUseWhenOneSizeFollowsAnother) {
  TileMemory memory;
  std::set<std::byte*> texels;  // every slot that there has been
  std::set<std::byte*> tables;
  const auto held_bytes = [&] { return bytes_in_memory(texels, kTexels) + bytes_in_memory(tables, kTable); };
  for (int round = 0; round < 3; ++round) {
    for (const std::size_t slot : {kTexels, kTable}) {
      std::set<std::byte*>& known = slot == kTexels ? texels : tables;
      const std::vector<std::byte*> taken = take_and_fill(memory, slot, kAll / slot);
      known.insert(taken.begin(), taken.end());
      EXPECT_LE(held_bytes(), kAll + TileMemory::kMostSpare);
      EXPECT_GE(held_bytes(), kAll);  // what is in use is seen
      for (std::byte* each : taken) memory.give_back(each, slot);
      EXPECT_LE(held_bytes(), TileMemory::kMostSpare);
    }
  }
}

TEST(TileMemory, SlotsOfEverySizeDoNotOverlap) {
  TileMemory memory;
  std::vector<std::pair<std::byte*, std::size_t>> taken;
  for (int round = 0; round < 40; ++round) {
    for (const std::size_t bytes : {1, 64, 3000, 32768, 40000, 98304, 65536}) {
      const std::size_t slot = TileMemory::slot_bytes(bytes);
      EXPECT_GE(slot, bytes);
      taken.emplace_back(memory.take(slot), slot);
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(taken.back().first) % 64, 0u);
    }
    if (round % 3 == 2) {
      memory.give_back(taken.front().first, taken.front().second);
      taken.erase(taken.begin());
    }
  }
  std::sort(taken.begin(), taken.end());
  for (std::size_t i = 0; i + 1 < taken.size(); ++i)
    EXPECT_LE(taken[i].first + taken[i].second, taken[i + 1].first);
}

}  // namespace
}  // namespace sweepkit::texmap
