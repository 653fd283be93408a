// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sweepkit/sweep/grid_patch.hpp"

namespace sweepkit::sweep {

struct DirectedEdge {
  std::uint32_t low, high;  ///< the vertices at its ends
  std::uint32_t triangle;
  std::uint32_t corner;  ///< it runs from this corner to the next
  bool is_upward;        ///< from `low` to `high`
};

/// The edges of triangles first to end - 1, by vertices; of those between the same two vertices, one that
/// runs up and one that runs down stand side by side as long as there are both, in the order of their
/// triangles.
std::vector<DirectedEdge> sorted_edges(std::span<const Triangle> triangles, std::uint32_t first,
                                       std::uint32_t end);

/// Do two neighbours in that list belong to one edge of a surface, run through once each way?
bool are_twins(const DirectedEdge& a, const DirectedEdge& b);

/// Calls visit(edge, twin) for each edge of the surface, twin a null pointer where it is open.
template <class Visit>
void for_each_edge(std::span<const DirectedEdge> sorted, Visit&& visit) {
  for (std::size_t i = 0; i < sorted.size();) {
    const bool has_twin = i + 1 < sorted.size() && are_twins(sorted[i], sorted[i + 1]);
    visit(sorted[i], has_twin ? &sorted[i + 1] : nullptr);
    i += has_twin ? 2 : 1;
  }
}

}  // namespace sweepkit::sweep
