// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <vector>

#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::texmap {
namespace {

std::size_t bytes_in_memory() {
  std::ifstream file("/proc/self/statm");
  std::size_t pages = 0;
  std::size_t resident = 0;
  file >> pages >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
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
// Two hundred blocks, a page each for the heap's own notes, the lists of slots, and what of the program is
// first used meanwhile: a megabyte or two. A size that kept its memory would take 96 more.
constexpr std::size_t kBesides = std::size_t{4} << 20;

TEST(TileMemory, TakesNoMoreThanIsInUseWhenOneSizeFollowsAnother) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer keeps memory of its own for every byte";
#endif
  TileMemory memory;
  const std::size_t before = bytes_in_memory();
  for (int round = 0; round < 3; ++round) {
    for (const std::size_t slot : {kTexels, kTable}) {
      const std::vector<std::byte*> taken = take_and_fill(memory, slot, kAll / slot);
      EXPECT_LT(bytes_in_memory() - before, kAll + TileMemory::kMostSpare + kBesides);
      for (std::byte* each : taken) memory.give_back(each, slot);
    }
  }
  EXPECT_LT(bytes_in_memory() - before, TileMemory::kMostSpare + kBesides);
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
