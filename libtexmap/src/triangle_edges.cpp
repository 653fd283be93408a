// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "triangle_edges.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <tuple>

namespace sweepkit::texmap {
namespace {

// The first index that has each index's position: an open hash table of indices, at most half full.
std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions) {
  const auto bits = [&](std::size_t i) {
    const glm::vec3 p = positions[i] + 0.0f;  // -0 and 0 are one place
    return std::array{std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                      std::bit_cast<std::uint32_t>(p.z)};
  };
  const std::size_t mask = std::bit_ceil(2 * positions.size() + 2) - 1;
  std::vector<std::uint32_t> table(mask + 1, kNoTwin);
  std::vector<std::uint32_t> place(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::array<std::uint32_t, 3> key = bits(i);
    std::uint64_t hash = 0;
    for (const std::uint32_t word : key) {
      hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    std::size_t slot = hash & mask;
    while (table[slot] != kNoTwin && bits(table[slot]) != key) slot = (slot + 1) & mask;
    if (table[slot] == kNoTwin) table[slot] = static_cast<std::uint32_t>(i);
    place[i] = table[slot];
  }
  return place;
}

struct Edge {
  std::uint32_t high;
  std::uint32_t id;
  bool is_upward;  // runs from its lower place to its higher one
};

// Pairs up opposite edges among those between the same two places, in order of their triangles.
void pair_up(std::span<const Edge> same, std::vector<std::uint32_t>& twins) {
  std::size_t up = 0;
  std::size_t down = 0;
  for (;;) {
    while (up < same.size() && !same[up].is_upward) ++up;
    while (down < same.size() && same[down].is_upward) ++down;
    if (up >= same.size() || down >= same.size()) return;
    const std::uint32_t a = same[up++].id;
    const std::uint32_t b = same[down++].id;
    if (a / 3 == b / 3) continue;
    twins[a] = b;
    twins[b] = a;
  }
}

}  // namespace

std::vector<std::uint32_t> find_twins(std::span<const glm::vec3> positions,
                                      std::span<const std::array<std::uint32_t, 3>> triangles) {
  const std::vector<std::uint32_t> place = weld(positions);
  // Edges in buckets by their lower place, each bucket in order of its edges.
  std::vector<std::uint32_t> ends(positions.size() + 1, 0);
  const auto for_each_edge = [&](auto&& visit) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t from = place[triangles[t][k]];
        const std::uint32_t to = place[triangles[t][(k + 1) % 3]];
        if (from != to) visit(from, to, 3 * t + k);
      }
    }
  };
  for_each_edge([&](std::uint32_t from, std::uint32_t to, std::uint32_t) { ++ends[std::min(from, to) + 1]; });
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
  std::vector<Edge> edges(ends.back());
  std::vector<std::uint32_t> next(ends.begin(), ends.end() - 1);
  for_each_edge([&](std::uint32_t from, std::uint32_t to, std::uint32_t id) {
    edges[next[std::min(from, to)]++] = {std::max(from, to), id, from < to};
  });

  std::vector<std::uint32_t> twins(3 * triangles.size(), kNoTwin);
  for (std::size_t low = 0; low < positions.size(); ++low) {
    const std::span<Edge> bucket(edges.data() + ends[low], edges.data() + ends[low + 1]);
    std::sort(bucket.begin(), bucket.end(),
              [](const Edge& a, const Edge& b) { return std::tie(a.high, a.id) < std::tie(b.high, b.id); });
    for (std::size_t first = 0; first < bucket.size();) {
      std::size_t last = first;
      while (last < bucket.size() && bucket[last].high == bucket[first].high) ++last;
      pair_up(bucket.subspan(first, last - first), twins);
      first = last;
    }
  }
  return twins;
}

}  // namespace sweepkit::texmap
