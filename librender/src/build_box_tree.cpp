// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Benthin, Woop, Niessner, Selgrad, Wald 2015], "Efficient ray tracing of subdivision surfaces
// using tessellation caching": boxes over blocks of a grid, refitted from the vertices up, and nothing to
// search. Departs from it: the whole mesh is one such tree instead of one a patch under a tree that is
// searched for; nodes have 16 children; blocks take the shape that the cells have in space
// (block_shapes.cpp).

#include "build_box_tree.hpp"

#include <algorithm>

#include "block_shapes.hpp"
#include "morton_order.hpp"

namespace sweepkit::render {
namespace {

// Nodes in one row that are all looked at cost less than another level above them that is hardly full.
constexpr std::uint32_t kMostEntries = 48;

struct FloatBox {
  glm::vec3 low{kNowhere};
  glm::vec3 high{-kNowhere};

  // In this form a NaN changes nothing.
  void add(const glm::vec3& p) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      low[axis] = p[axis] < low[axis] ? p[axis] : low[axis];
      high[axis] = p[axis] > high[axis] ? p[axis] : high[axis];
    }
  }
};

std::uint32_t blocks_for(std::uint32_t count, std::uint32_t block) {
  return (count + block - 1) / block;
}

FloatBox bounds_of(const BoxNode& node) {
  FloatBox box;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = *std::min_element(node.low[axis], node.low[axis] + kWidth);
    box.high[axis] = *std::max_element(node.high[axis], node.high[axis] + kWidth);
  }
  return box;
}

// Appends the nodes over `columns` x `rows` children and the level that tells of them.
void add_level(BoxTree& tree, Level::Children children, std::uint8_t log_columns, std::uint32_t columns,
               std::uint32_t rows) {
  Level level;
  level.children = children;
  level.log_columns = log_columns;
  level.first_node = static_cast<std::uint32_t>(tree.nodes.size());
  level.columns = blocks_for(columns, 1u << log_columns);
  level.rows = blocks_for(rows, kWidth >> log_columns);
  BoxNode empty;
  std::fill_n(empty.low[0], 3 * kWidth, kNowhere);
  std::fill_n(empty.high[0], 3 * kWidth, -kNowhere);
  tree.nodes.resize(tree.nodes.size() + std::size_t{level.columns} * level.rows, empty);
  tree.levels.push_back(level);
}

void set_child(BoxTree& tree, const Level& level, std::uint32_t x, std::uint32_t y, const FloatBox& box) {
  const std::uint32_t log_rows = 4u - level.log_columns;
  BoxNode& node =
      tree.nodes[level.first_node + std::size_t{y >> log_rows} * level.columns + (x >> level.log_columns)];
  const std::uint32_t child =
      (x & ((1u << level.log_columns) - 1)) + ((y & ((1u << log_rows) - 1)) << level.log_columns);
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    node.low[axis][child] = box.low[axis];
    node.high[axis][child] = box.high[axis];
  }
}

// The level above the last one, its boxes from that one's nodes.
void add_level_above(BoxTree& tree, std::uint8_t log_columns) {
  const Level below = tree.levels.back();
  add_level(tree, Level::Children::kNodes, log_columns, below.columns, below.rows);
  const Level level = tree.levels.back();
  std::size_t node = below.first_node;
  for (std::uint32_t y = 0; y < below.rows; ++y) {
    for (std::uint32_t x = 0; x < below.columns; ++x)
      set_child(tree, level, x, y, bounds_of(tree.nodes[node++]));
  }
}

void add_entries_of_last_level(BoxTree& tree) {
  const auto index = static_cast<std::uint32_t>(tree.levels.size() - 1);
  for (std::uint32_t y = 0; y < tree.levels[index].rows; ++y) {
    for (std::uint32_t x = 0; x < tree.levels[index].columns; ++x) tree.entries.push_back({index, x, y});
  }
}

// Boxes of the leaves, one band of them after another. Down the rows whole rows of floats are compared at
// once, whatever their axis; then across the few vertices of a leaf.
void set_leaf_boxes(BoxTree& tree, const scene::MeshView& mesh, const LeafGrid& grid,
                    const LeafShape& leaves) {
  const Level level = tree.levels.back();
  const auto [width, height] = kLeafShapes[grid.shape];
  std::vector<float> low(3 * std::size_t{grid.stride});
  std::vector<float> high(low.size());
  const std::size_t floats = low.size();
  for (std::uint32_t y = 0; y < leaves.rows; ++y) {
    const std::uint32_t first_row = std::min(y * height, grid.rows - height);
    std::fill(low.begin(), low.end(), kNowhere);
    std::fill(high.begin(), high.end(), -kNowhere);
    for (std::uint32_t j = first_row; j <= first_row + height; ++j) {
      const float* row = &mesh.positions[grid.first_vertex + std::size_t{j} * grid.stride].x;
      float* const row_low = low.data();
      float* const row_high = high.data();
      for (std::size_t k = 0; k < floats; ++k) {
        row_low[k] = row[k] < row_low[k] ? row[k] : row_low[k];
        row_high[k] = row[k] > row_high[k] ? row[k] : row_high[k];
      }
    }
    for (std::uint32_t x = 0; x < leaves.columns; ++x) {
      const std::uint32_t first_column = std::min(x * width, grid.columns - width);
      FloatBox box;
      for (std::uint32_t i = first_column; i <= first_column + width; ++i) {
        for (glm::length_t axis = 0; axis < 3; ++axis) {
          box.low[axis] = std::min(box.low[axis], low[3 * std::size_t{i} + axis]);
          box.high[axis] = std::max(box.high[axis], high[3 * std::size_t{i} + axis]);
        }
      }
      set_child(tree, level, x, y, box);
    }
  }
}

void set_lane_offsets(LeafGrid& grid) {
  const auto [width, height] = kLeafShapes[grid.shape];
  for (std::uint32_t lane = 0; lane < (width + 1) * (height + 1); ++lane) {
    const std::uint32_t vertex = lane / (width + 1) * grid.stride + lane % (width + 1);
    grid.offsets[lane] = static_cast<std::int32_t>(3 * vertex);
  }
}

void add_grid(BoxTree& tree, const scene::MeshView& mesh, LeafGrid grid, std::uint32_t most_entries) {
  const LeafShape shape = kLeafShapes[grid.shape];
  set_lane_offsets(grid);
  const LeafShape leaves = {blocks_for(grid.columns, shape.columns), blocks_for(grid.rows, shape.rows)};
  LeafShape child = shape;
  std::uint8_t log_columns = choose_log_columns(mesh, grid, leaves.columns, leaves.rows, child);
  add_level(tree, Level::Children::kGridLeaves, log_columns, leaves.columns, leaves.rows);
  tree.levels.back().grid = static_cast<std::uint32_t>(tree.grids.size());
  tree.grids.push_back(grid);
  set_leaf_boxes(tree, mesh, grid, leaves);
  while (std::uint64_t{tree.levels.back().columns} * tree.levels.back().rows > most_entries) {
    child.columns <<= log_columns;
    child.rows <<= 4 - log_columns;
    const Level& below = tree.levels.back();
    log_columns = choose_log_columns(mesh, grid, below.columns, below.rows, child);
    add_level_above(tree, log_columns);
  }
  add_entries_of_last_level(tree);
}

void add_loose(BoxTree& tree, const scene::MeshView& mesh) {
  if (tree.loose.empty()) return;
  const std::vector<std::uint32_t> unordered = tree.loose;
  const auto order =
      morton_order(static_cast<std::uint32_t>(unordered.size()), tree.box, [&](std::uint32_t i) {
        const auto& [a, b, c] = mesh.triangles[unordered[i]];
        return (glm::dvec3(mesh.positions[a]) + glm::dvec3(mesh.positions[b]) +
                glm::dvec3(mesh.positions[c])) /
               3.0;
      });
  for (std::size_t i = 0; i < order.size(); ++i) tree.loose[i] = unordered[order[i]];
  const std::uint32_t leaves = blocks_for(static_cast<std::uint32_t>(tree.loose.size()), kWidth);
  add_level(tree, Level::Children::kLooseLeaves, 4, leaves, 1);
  const Level level = tree.levels.back();
  for (std::uint32_t x = 0; x < leaves; ++x) {
    FloatBox box;
    const std::size_t end = std::min(tree.loose.size(), std::size_t{kWidth} * (x + 1));
    for (std::size_t i = std::size_t{kWidth} * x; i < end; ++i) {
      for (const std::uint32_t v : mesh.triangles[tree.loose[i]]) box.add(mesh.positions[v]);
    }
    set_child(tree, level, x, 0, box);
  }
  while (tree.levels.back().columns > kMostEntries) add_level_above(tree, 4);
  add_entries_of_last_level(tree);
}

FloatBox bounds_of_entry(const BoxTree& tree, const Place& place) {
  const Level& level = tree.levels[place.level];
  return bounds_of(tree.nodes[level.first_node + std::size_t{place.y} * level.columns + place.x]);
}

void add_roots(BoxTree& tree) {
  const auto count = static_cast<std::uint32_t>(tree.entries.size());
  if (count > kMostEntries) {
    const std::vector<Place> unordered = tree.entries;
    const auto order = morton_order(count, tree.box, [&](std::uint32_t i) {
      const FloatBox box = bounds_of_entry(tree, unordered[i]);
      return 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
    });
    for (std::uint32_t i = 0; i < count; ++i) tree.entries[i] = unordered[order[i]];
  }
  add_level(tree, Level::Children::kEntries, 4, count, 1);
  const Level level = tree.levels.back();
  for (std::uint32_t i = 0; i < count; ++i)
    set_child(tree, level, i, 0, bounds_of_entry(tree, tree.entries[i]));
  while (tree.levels.back().columns > kMostEntries / kWidth) add_level_above(tree, 4);
}

// The cells of a patch as a grid for leaves, if it has enough of them and its triangles are where GridPatch
// says.
bool has_grid(const scene::MeshView& mesh, const sweep::GridPatch& patch, LeafGrid& grid) {
  const std::uint32_t first_row = patch.has_first_pole ? 1 : 0;
  const std::uint32_t end_row = patch.rows - (patch.has_last_pole ? 1 : 0);
  if (end_row <= first_row || patch.columns == 0) return false;
  grid.first_vertex = patch.vertex(0, first_row);
  grid.first_triangle = patch.first_triangle_of_row(first_row);
  grid.columns = patch.columns;
  grid.rows = end_row - first_row;
  grid.stride = patch.columns + 1;
  const std::uint32_t p = grid.first_vertex;
  const sweep::Triangle& first = mesh.triangles[grid.first_triangle];
  grid.is_turned = first == sweep::Triangle{p + 1, p, p + grid.stride};
  if (!grid.is_turned && first != sweep::Triangle{p + grid.stride, p, p + 1}) return false;
  const auto shape = choose_leaf_shape(mesh, grid);
  grid.shape = shape.value_or(0);
  return shape.has_value();
}

}  // namespace

BoxTree build_box_tree(const scene::MeshView& mesh) {
  BoxTree tree;
  const auto take_loose = [&](std::uint32_t from, std::uint32_t end) {
    for (std::uint32_t t = from; t < end; ++t) tree.loose.push_back(t);
  };
  const auto patches = static_cast<std::uint32_t>(mesh.patches.size());
  const std::uint32_t most_entries = std::max(kMostEntries / std::max(patches, 1u), 3u);
  std::uint32_t next = 0;
  for (const sweep::GridPatch& patch : mesh.patches) {
    LeafGrid grid;
    if (!has_grid(mesh, patch, grid)) continue;
    take_loose(next, grid.first_triangle);
    next = grid.first_triangle + 2 * grid.columns * grid.rows;
    add_grid(tree, mesh, grid, most_entries);
  }
  take_loose(next, static_cast<std::uint32_t>(mesh.triangles.size()));

  FloatBox box;
  for (const Place& entry : tree.entries) {
    const FloatBox part = bounds_of_entry(tree, entry);
    box.add(part.low);
    box.add(part.high);
  }
  for (const std::uint32_t t : tree.loose) {
    for (const std::uint32_t v : mesh.triangles[t]) box.add(mesh.positions[v]);
  }
  tree.box = {glm::dvec3(box.low), glm::dvec3(box.high)};
  for (int axis = 0; axis < 3; ++axis) {
    tree.reach = std::max({tree.reach, std::abs(tree.box.low[axis]), std::abs(tree.box.high[axis])});
    tree.extent += tree.box.high[axis] - tree.box.low[axis];
  }
  tree.padded_low = {tree.box.low.x, tree.box.low.y, tree.box.low.z, -1};
  tree.padded_high = {tree.box.high.x, tree.box.high.y, tree.box.high.z, 1};
  add_loose(tree, mesh);
  add_roots(tree);
  return tree;
}

}  // namespace sweepkit::render
