// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "directed_edges.hpp"

#include <algorithm>
#include <tuple>

namespace sweepkit::sweep {

std::vector<DirectedEdge> sorted_edges(std::span<const Triangle> triangles, std::uint32_t first,
                                       std::uint32_t end) {
  std::vector<DirectedEdge> edges;
  edges.reserve(std::size_t{3} * (end - first));
  for (std::uint32_t t = first; t < end; ++t) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t from = triangles[t][c];
      const std::uint32_t to = triangles[t][(c + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), t, c, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
  });
  // Where more than two triangles meet, or one is turned over, ups and downs are dealt out in turn.
  std::vector<DirectedEdge> dealt;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t last = i;
    while (last < edges.size() && edges[last].low == edges[i].low && edges[last].high == edges[i].high)
      ++last;
    if (last - i > 2) {
      dealt.clear();
      std::size_t up = i;
      std::size_t down = i;
      const auto next = [&](std::size_t from, bool is_upward) {
        while (from < last && edges[from].is_upward != is_upward) ++from;
        return from;
      };
      for (;;) {
        up = next(up, true);
        down = next(down, false);
        if (up == last && down == last) break;
        if (up < last) dealt.push_back(edges[up++]);
        if (down < last) dealt.push_back(edges[down++]);
      }
      std::copy(dealt.begin(), dealt.end(), edges.begin() + static_cast<std::ptrdiff_t>(i));
    }
    i = last;
  }
  return edges;
}

bool are_twins(const DirectedEdge& a, const DirectedEdge& b) {
  return a.low == b.low && a.high == b.high && a.is_upward != b.is_upward && a.triangle != b.triangle;
}

}  // namespace sweepkit::sweep
