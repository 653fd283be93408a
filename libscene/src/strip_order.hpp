// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

/// A mesh's vertices and triangles in another order.
struct MeshOrder {
  std::vector<std::uint32_t> vertices;     ///< those of the mesh that are in use, each once
  std::vector<sweep::Triangle> triangles;  ///< of indices into `vertices`
};

/// The order in which EXT_meshopt_compression packs a mesh best. Its codec writes one byte for a triangle
/// that shares an edge with a recent one and whose third corner is either the next new vertex or the one
/// after the last that was named, and what is left of a vertex beside the one before. So a grid patch is
/// walked cell by cell along the way on which its vertices change less, as one strip a line of cells, with
/// the vertices numbered line by line: its lower line is then always the next vertex, its upper line the one
/// after. Triangles of no patch go first.
MeshOrder strip_order(const MeshView& mesh);

/// Leaves out the vertices that no triangle has any more: the codec's next new vertex would wait for them.
void drop_unused_vertices(MeshOrder& order);

/// The items in the order's.
template <class T>
std::vector<T> in_order(std::span<const T> items, const MeshOrder& order) {
  std::vector<T> result;
  result.reserve(items.size());
  for (const std::uint32_t vertex : order.vertices) result.push_back(items[vertex]);
  return result;
}

}  // namespace sweepkit::scene
