// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "voxel_grid.hpp"

namespace sweepkit::render {

inline constexpr std::uint32_t kWidth = 16;  ///< children of a node, vertices or triangles of a leaf

/// The bounds of 16 children, axis by axis. A child that is not there lies kNowhere, turned inside out: no
/// ray meets it, and no product with it is NaN.
struct alignas(64) BoxNode {
  float low[3][kWidth];
  float high[3][kWidth];
};
inline constexpr float kNowhere = 0x1p100F;

/// How many cells a leaf of a grid has along u and v. Its vertices fill the 16 lanes row by row.
struct LeafShape {
  std::uint32_t columns;
  std::uint32_t rows;
};
inline constexpr std::array<LeafShape, 5> kLeafShapes = {{{3, 3}, {4, 2}, {2, 4}, {7, 1}, {1, 7}}};

/// The cells of a GridPatch without its pole rows: a full grid. Vertex (i, j) is first_vertex + j * stride +
/// i; cell (i, j) has the triangles first_triangle + 2 * (j * columns + i) and the one after it.
struct LeafGrid {
  std::uint32_t first_vertex = 0;
  std::uint32_t first_triangle = 0;
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::uint32_t stride = 0;
  std::uint32_t shape = 0;  ///< index into kLeafShapes
  bool is_turned = false;   ///< a mirrored part: A and C have changed places
  /// Of a leaf's vertices, by lane: floats from its first vertex. Lanes too many repeat the first.
  alignas(64) std::array<std::int32_t, kWidth> offsets{};
};

/// Nodes of equal height, laid out as a grid: what lies where follows from indices alone.
struct Level {
  enum class Children : std::uint8_t {
    kGridLeaves,   ///< leaves of a grid
    kLooseLeaves,  ///< 16 of the loose triangles each
    kNodes,        ///< nodes of the level before
    kEntries,      ///< nodes that `entries` tells, 16 in a row
  };
  Children children = Children::kNodes;
  std::uint8_t log_columns = 4;  ///< a node's 16 children as 2^log_columns columns of 2^(4 - log_columns)
  std::uint32_t first_node = 0;  ///< node (x, y) is first_node + y * columns + x
  std::uint32_t grid = 0;        ///< that the leaves are of
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;

  std::uint32_t child_x(std::uint32_t x, std::uint32_t child) const {
    return (x << log_columns) + (child & ((1u << log_columns) - 1));
  }
  std::uint32_t child_y(std::uint32_t y, std::uint32_t child) const {
    return (y << (4 - log_columns)) + (child >> log_columns);
  }
};

/// A node, by its place.
struct Place {
  std::uint32_t level;
  std::uint32_t x;
  std::uint32_t y;
};

/// The implicit hierarchy over a mesh: boxes, and the few numbers that tell what they bound. The vertices
/// stay where they are.
struct BoxTree {
  Box box;  ///< of all triangles
  // The same for four lanes: the fourth axis is from -1 to 1.
  alignas(32) std::array<double, 4> padded_low{};
  alignas(32) std::array<double, 4> padded_high{};
  double reach = 0;   ///< the largest coordinate of it, up to sign
  double extent = 0;  ///< its width, height and depth together
  std::vector<BoxNode> nodes;
  std::vector<Level> levels;  ///< the last one holds the roots, a few nodes in one row
  std::vector<LeafGrid> grids;
  std::vector<std::uint32_t> loose;  ///< triangles of no grid, neighbours in space near each other
  std::vector<Place> entries;  ///< where the grids' own trees begin, neighbours in space near each other

  std::size_t bytes() const {
    return nodes.size() * sizeof(BoxNode) + levels.size() * sizeof(Level) + grids.size() * sizeof(LeafGrid) +
           loose.size() * sizeof(std::uint32_t) + entries.size() * sizeof(Place);
  }
};

}  // namespace sweepkit::render
