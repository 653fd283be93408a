// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// An open hash table of indices, at most half full.

#include "weld.hpp"

#include <bit>

namespace sweepkit::scene {

std::vector<glm::dvec3> weld(std::span<const glm::dvec3> all, std::vector<std::uint32_t>& places) {
  constexpr std::uint32_t kEmpty = 0xFFFFFFFF;
  std::vector<glm::dvec3> once;
  const std::size_t mask = std::bit_ceil(2 * all.size() + 2) - 1;
  std::vector<std::uint32_t> table(mask + 1, kEmpty);
  places.clear();
  places.reserve(all.size());
  for (const glm::dvec3& given : all) {
    const glm::dvec3 p = given + 0.0;  // -0 becomes 0
    std::uint64_t hash = 0;
    for (glm::length_t k = 0; k < 3; ++k) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(p[k])) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    std::size_t slot = hash & mask;
    while (table[slot] != kEmpty && once[table[slot]] != p) slot = (slot + 1) & mask;
    if (table[slot] == kEmpty) {
      table[slot] = static_cast<std::uint32_t>(once.size());
      once.push_back(p);
    }
    places.push_back(table[slot]);
  }
  return once;
}

}  // namespace sweepkit::scene
