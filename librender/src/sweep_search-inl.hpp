// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The search for one ray. For inclusion once an instruction set, as lanes-inl.hpp.

#if defined(SWEEPKIT_SWEEP_SEARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWEEPKIT_SWEEP_SEARCH_INL
#undef SWEEPKIT_SWEEP_SEARCH_INL
#else
#define SWEEPKIT_SWEEP_SEARCH_INL
#endif

#include <bit>

#include "box_tree.hpp"
#include "culling_ray.hpp"
#include "lanes-inl.hpp"
#include "leaf_test-inl.hpp"
#include "linear_scan.hpp"
#include "reach-inl.hpp"
#include "sweep_kernels.hpp"
#include "triangle_test.hpp"

HWY_BEFORE_NAMESPACE();
namespace sweepkit::render::HWY_NAMESPACE {

/// Children that a ray meets, nearest first. A key is where the ray enters the child's box, as the bits of a
/// float at least 0 (which order as the numbers do), its last four bits the child's index.
struct Children {
  std::uint32_t count;
  alignas(64) std::uint32_t keys[kWidth];
};

HWY_INLINE float entry_of(std::uint32_t key) {
  return std::bit_cast<float>(key & ~15u);
}

/// Puts keys[count] where it belongs among those before it.
HWY_INLINE void sort_in(std::uint32_t* keys, std::uint32_t count) {
  const std::uint32_t key = keys[count];
  std::uint32_t at = count;
  for (; at > 0 && keys[at - 1] > key; --at) keys[at] = keys[at - 1];
  keys[at] = key;
}

/// The children whose boxes the ray passes between 0 and `limit`, by lane.
HWY_INLINE std::uint32_t passed(const BoxNode& node, const CullingRay& ray, float limit, Lanes& enter) {
  const float* planes = node.low[0];
  enter = set(0.0F);
  Lanes leave = set(limit);
  for (int axis = 0; axis < 3; ++axis) {
    const Lanes inverse = set(ray.inverse[axis]);
    enter = max(multiply_add(load(planes + ray.near_plane[axis]), inverse, set(ray.near_shift[axis])), enter);
    leave = min(multiply_add(load(planes + ray.far_plane[axis]), inverse, set(ray.far_shift[axis])), leave);
  }
  return less_equal(enter, leave);
}

HWY_INLINE void sort_children(std::uint32_t bits, const Lanes& enter, Children& children) {
  children.count = pack_keys(enter, bits, children.keys);
  for (std::uint32_t i = 1; i < children.count; ++i) sort_in(children.keys, i);
}

/// Of up to four keys, the greatest first. Without branches: how children lie cannot be predicted.
HWY_INLINE void sort_four_down(std::uint32_t keys[4]) {
  const auto order = [&](int a, int b) HWY_ATTR {
    const std::uint32_t greater = std::max(keys[a], keys[b]);
    keys[b] = std::min(keys[a], keys[b]);
    keys[a] = greater;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
}

/// Width, height and depth of a child's box together.
HWY_INLINE float extent_of(const BoxNode& node, std::uint32_t child) {
  return (node.high[0][child] - node.low[0][child]) + (node.high[1][child] - node.low[1][child]) +
         (node.high[2][child] - node.low[2][child]);
}

/// The exact end of every search: what is left of a leaf's triangles. A search is one that looks for the
/// nearest hit, or for any before `end`.
struct NearestSearch {
  static constexpr bool kEndsAtFirst = false;
  Hit& best;

  double end() const { return best.t; }
  void take(const Hit& found, std::uint32_t object, std::uint32_t triangle) {
    keep_nearer(best, found, object, triangle);
  }
  bool is_done() const { return false; }
};

struct AnySearch {
  static constexpr bool kEndsAtFirst = true;
  double limit;
  bool is_found = false;

  double end() const { return limit; }
  void take(const Hit& found, std::uint32_t /*object*/, std::uint32_t /*triangle*/) {
    is_found = is_found || found.t < limit;
  }
  bool is_done() const { return is_found; }
};

/// True where there is a hit before the end.
template <class Search>
HWY_INLINE bool test(const TreeView& view, const Ray& ray, const ShearedRay& sheared, const LeafTriangle& t,
                     Search& search) {
  const auto& positions = view.mesh->positions;
  Hit found;
  if (!sheared.meets(positions[t.vertices[0]], positions[t.vertices[1]], positions[t.vertices[2]],
                     search.end(), found) ||
      ray.leaves(view.object, t.index)) {
    return false;
  }
  search.take(found, view.object, t.index);
  return true;
}

/// Calls function.template operator()<shape>() for the shape of the grid.
template <class Function>
HWY_INLINE void with_shape(std::uint32_t shape, const Function& function) {
  static_assert(kLeafShapes.size() == 5);
  switch (shape) {
    case 0:
      return function.template operator()<0>();
    case 1:
      return function.template operator()<1>();
    case 2:
      return function.template operator()<2>();
    case 3:
      return function.template operator()<3>();
    default:
      return function.template operator()<4>();
  }
}

/// What a search through the tree asks of a ray.
template <class Search>
struct RayVisitor {
  const TreeView& view;
  const Ray& ray;
  const ShearedRay& sheared;
  const CullingRay& culling;
  Search& search;
  bool is_done = false;

  HWY_INLINE float limit() const { return culling.limit(search.end()); }
  HWY_INLINE bool is_over() const { return Search::kEndsAtFirst && is_done; }
  HWY_INLINE std::uint32_t passed_children(const BoxNode& node, float limit, Lanes& enter) const {
    return passed(node, culling, limit, enter);
  }
  /// Asks for the vertices of all of them before the first is waited for.
  HWY_INLINE void prefetch_leaves(const Level& level, const Place& at, std::uint32_t bits) const {
    if (level.children != Level::Children::kGridLeaves) return;
    const LeafGrid& grid = view.tree->grids[level.grid];
    const LeafShape shape = kLeafShapes[grid.shape];
    const float* const vertices = &view.mesh->positions[grid.first_vertex].x;
    for (; bits != 0; bits &= bits - 1) {
      const auto child = static_cast<std::uint32_t>(std::countr_zero(bits));
      const std::uint32_t column =
          std::min(level.child_x(at.x, child) * shape.columns, grid.columns - shape.columns);
      const std::uint32_t row = std::min(level.child_y(at.y, child) * shape.rows, grid.rows - shape.rows);
      const float* from = vertices + 3 * (std::size_t{row} * grid.stride + column);
      for (std::uint32_t j = 0; j <= shape.rows; ++j)
        __builtin_prefetch(from + 3 * std::size_t{j} * grid.stride);
    }
  }
  /// False: nothing has changed.
  HWY_INLINE bool visit_leaf(const Level& level, const BoxNode& node, std::uint32_t child, std::uint32_t x,
                             std::uint32_t y) {
    const float extent = extent_of(node, child);
    bool is_found = false;
    const BoxTree& tree = *view.tree;
    if (level.children == Level::Children::kGridLeaves) {
      const LeafGrid& grid = tree.grids[level.grid];
      with_shape(grid.shape, [&]<std::uint32_t kShape>() HWY_ATTR {
        const GridLeaf leaf = grid_leaf<kShape>(grid, x, y);
        std::uint32_t bits = triangles_near<kShape>(view, grid, leaf, culling, extent);
        for (; bits != 0 && !is_over(); bits &= bits - 1) {
          const auto bit = static_cast<std::uint32_t>(std::countr_zero(bits));
          is_found |= take(triangle_of<kShape>(grid, leaf, bit));
        }
      });
      return is_found;
    }
    std::uint32_t bits = loose_triangles_near(view, x, culling, extent);
    for (; bits != 0 && !is_over(); bits &= bits - 1) {
      const std::uint32_t index = tree.loose[kWidth * x + static_cast<std::uint32_t>(std::countr_zero(bits))];
      is_found |= take({index, view.mesh->triangles[index]});
    }
    return is_found;
  }
  HWY_INLINE bool take(const LeafTriangle& triangle) {
    if (!test(view, ray, sheared, triangle, search)) return false;
    is_done = search.is_done();
    return true;
  }
};

/// A child that waits: its key and its parent.
struct Waiting {
  std::uint32_t key;
  Place parent;
};

// Of the roots at most 48 children wait, and of a node 15 while one is looked at; there are at most 8 levels
// of 16 over 2^32 leaves, and as many over the entries.
inline constexpr std::size_t kMostWaiting = 48 + 16 * 16;

HWY_INLINE Place child_of(const BoxTree& tree, const Place& parent, std::uint32_t key) {
  const Level& level = tree.levels[parent.level];
  const std::uint32_t child = key & 15;
  if (level.children == Level::Children::kEntries) return tree.entries[kWidth * parent.x + child];
  return {parent.level - 1, level.child_x(parent.x, child), level.child_y(parent.y, child)};
}

/// Nearest first, as far as the visitor's limit, which draws nearer as it finds hits.
template <class Visitor>
HWY_INLINE void search_tree(const BoxTree& tree, Visitor& visitor) {
  const Level* const levels = tree.levels.data();
  Waiting waiting[kMostWaiting];
  std::size_t count = 0;
  float limit = visitor.limit();

  const auto top = static_cast<std::uint32_t>(tree.levels.size() - 1);
  bool has_place = levels[top].columns == 1;
  Place at{top, 0, 0};
  // All roots first where there are several: they do not wait for each other.
  for (std::uint32_t x = 0; !has_place && x < levels[top].columns; ++x) {
    Lanes enter;
    const std::uint32_t bits = visitor.passed_children(tree.nodes[levels[top].first_node + x], limit, enter);
    if (bits == 0) continue;
    alignas(64) std::uint32_t keys[kWidth];
    const std::uint32_t children = pack_keys(enter, bits, keys);
    for (std::uint32_t i = 0; i < children; ++i) {
      // The nearest comes last.
      std::size_t k = count++;
      for (; k > 0 && waiting[k - 1].key < keys[i]; --k) waiting[k] = waiting[k - 1];
      waiting[k] = {keys[i], {top, x, 0}};
    }
  }
  while (true) {
    if (!has_place) {
      do {
        if (count == 0) return;
        --count;
      } while (entry_of(waiting[count].key) > limit);
      at = child_of(tree, waiting[count].parent, waiting[count].key);
    }
    has_place = false;
    // Down to a node of leaves, or to nothing.
    while (true) {
      const Level& level = levels[at.level];
      const BoxNode& node = tree.nodes[level.first_node + at.y * level.columns + at.x];
      Lanes enter;
      const std::uint32_t bits = visitor.passed_children(node, limit, enter);
      if (bits == 0) break;
      const bool is_single = (bits & (bits - 1)) == 0;
      if (level.children == Level::Children::kNodes || level.children == Level::Children::kEntries) {
        std::uint32_t next = static_cast<std::uint32_t>(std::countr_zero(bits));
        if (!is_single) {
          Children children;
          children.count = pack_keys(enter, bits, children.keys);
          if (children.count <= 4) {
            // What is not there is 0, and so comes last.
            sort_four_down(children.keys);
            for (std::uint32_t i = 0; i < 3; ++i) waiting[count + i] = {children.keys[i], at};
            next = children.keys[children.count - 1];
          } else {
            for (std::uint32_t i = 1; i < children.count; ++i) sort_in(children.keys, i);
            for (std::uint32_t i = 1; i < children.count; ++i)
              waiting[count + i - 1] = {children.keys[children.count - i], at};
            next = children.keys[0];
          }
          count += children.count - 1;
        }
        at = child_of(tree, at, next);
        continue;
      }
      visitor.prefetch_leaves(level, at, bits);
      Children children;
      if (is_single) {
        children.count = 1;
        children.keys[0] = static_cast<std::uint32_t>(std::countr_zero(bits));
      } else {
        sort_children(bits, enter, children);
      }
      for (std::uint32_t i = 0; i < children.count && entry_of(children.keys[i]) <= limit; ++i) {
        const std::uint32_t child = children.keys[i] & 15;
        if (!visitor.visit_leaf(level, node, child, level.child_x(at.x, child), level.child_y(at.y, child)))
          continue;
        if (visitor.is_over()) return;
        limit = visitor.limit();
      }
      break;
    }
  }
}

inline void find_nearest(const TreeView& view, const Ray& ray, Hit& best) {
  CullingRay culling;
  switch (reach(ray, *view.tree, culling)) {
    case Reach::kMisses:
      return;
    case Reach::kUnusual:
      return LinearScan(*view.mesh).find_nearest(ray, view.object, best);
    case Reach::kMayHit:
      break;
  }
  const ShearedRay sheared(ray);
  set_shear(sheared, culling);
  NearestSearch search{best};
  RayVisitor<NearestSearch> visitor{view, ray, sheared, culling, search};
  search_tree(*view.tree, visitor);
}

inline bool is_blocked(const TreeView& view, const Ray& ray, double end) {
  CullingRay culling;
  switch (reach(ray, *view.tree, culling)) {
    case Reach::kMisses:
      return false;
    case Reach::kUnusual:
      return LinearScan(*view.mesh).is_blocked(ray, view.object, end);
    case Reach::kMayHit:
      break;
  }
  const ShearedRay sheared(ray);
  set_shear(sheared, culling);
  AnySearch search{end};
  RayVisitor<AnySearch> visitor{view, ray, sheared, culling, search};
  search_tree(*view.tree, visitor);
  return search.is_found;
}

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
