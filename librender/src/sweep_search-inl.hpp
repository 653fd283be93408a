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

HWY_INLINE float entry_of(std::uint32_t key) { return std::bit_cast<float>(key & ~15u); }

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
  if (children.count == 2) {
    const std::uint32_t a = children.keys[0];
    const std::uint32_t b = children.keys[1];
    children.keys[0] = std::min(a, b);
    children.keys[1] = std::max(a, b);
    return;
  }
  for (std::uint32_t i = 1; i < children.count; ++i) sort_in(children.keys, i);
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
};

struct AnySearch {
  static constexpr bool kEndsAtFirst = true;
  double limit;
  bool is_found = false;

  double end() const { return limit; }
  void take(const Hit& found, std::uint32_t /*object*/, std::uint32_t /*triangle*/) {
    is_found = found.t < limit;
  }
};

/// True where the search is over.
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
  if constexpr (Search::kEndsAtFirst) return search.is_found;
  return false;
}

/// One leaf: true where the search is over.
template <class Search>
HWY_INLINE bool search_leaf(const TreeView& view, const Level& level, std::uint32_t x, std::uint32_t y,
                            float extent, const Ray& ray, const ShearedRay& sheared,
                            const CullingRay& culling, Search& search) {
  const BoxTree& tree = *view.tree;
  if (level.children == Level::Children::kGridLeaves) {
    const LeafGrid& grid = tree.grids[level.grid];
    const GridLeaf leaf = grid_leaf(grid, x, y);
    std::uint32_t bits = triangles_near(view, grid, leaf, culling, extent);
    for (; bits != 0; bits &= bits - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(bits));
      if (test(view, ray, sheared, triangle_of(grid, leaf, bit), search)) return true;
    }
    return false;
  }
  std::uint32_t bits = loose_triangles_near(view, x, culling, extent);
  for (; bits != 0; bits &= bits - 1) {
    const std::uint32_t index = tree.loose[kWidth * x + static_cast<std::uint32_t>(std::countr_zero(bits))];
    if (test(view, ray, sheared, {index, view.mesh->triangles[index]}, search)) return true;
  }
  return false;
}

struct Waiting {
  std::uint32_t key;
  Place place;
};

// Of the roots at most 48 children wait, and of a node 15 while one is looked at; there are at most 8 levels
// of 16 over 2^32 leaves, and as many over the entries.
inline constexpr std::size_t kMostWaiting = 48 + 16 * 16;

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
  HWY_INLINE std::uint32_t passed_children(const BoxNode& node, float limit, Lanes& enter) const {
    return passed(node, culling, limit, enter);
  }
  HWY_INLINE bool visit_leaf(const Level& level, const BoxNode& node, std::uint32_t child, std::uint32_t x,
                             std::uint32_t y) {
    is_done = search_leaf(view, level, x, y, extent_of(node, child), ray, sheared, culling, search);
    return true;
  }
  HWY_INLINE bool is_over() const { return Search::kEndsAtFirst && is_done; }
};

template <class Visitor>
HWY_INLINE void search_tree(const BoxTree& tree, Visitor& visitor) {
  const Level* const levels = tree.levels.data();
  Waiting waiting[kMostWaiting];
  std::size_t count = 0;
  float limit = visitor.limit();
  const auto push = [&](const Level& level, const Place& at, std::uint32_t key) HWY_ATTR {
    const std::uint32_t child = key & 15;
    waiting[count++] = {key, level.children == Level::Children::kEntries
                                 ? tree.entries[kWidth * at.x + child]
                                 : Place{at.level - 1, level.child_x(at.x, child), level.child_y(at.y, child)}};
  };

  // All roots first: they do not wait for each other.
  const auto top = static_cast<std::uint32_t>(tree.levels.size() - 1);
  for (std::uint32_t x = 0; x < levels[top].columns; ++x) {
    Lanes enter;
    const std::uint32_t bits = visitor.passed_children(tree.nodes[levels[top].first_node + x], limit, enter);
    if (bits == 0) continue;
    Children children;
    children.count = pack_keys(enter, bits, children.keys);
    for (std::uint32_t i = 0; i < children.count; ++i) {
      push(levels[top], {top, x, 0}, children.keys[i]);
      // The nearest comes last.
      const Waiting last = waiting[count - 1];
      std::size_t k = count - 1;
      for (; k > 0 && waiting[k - 1].key < last.key; --k) waiting[k] = waiting[k - 1];
      waiting[k] = last;
    }
  }
  while (true) {
    do {
      if (count == 0) return;
      --count;
    } while (entry_of(waiting[count].key) > limit);
    const Place at = waiting[count].place;
    const Level& level = levels[at.level];
    const BoxNode& node = tree.nodes[level.first_node + at.y * level.columns + at.x];
    Lanes enter;
    const std::uint32_t bits = visitor.passed_children(node, limit, enter);
    if (bits == 0) continue;
    Children children;
    sort_children(bits, enter, children);
    if (level.children == Level::Children::kGridLeaves || level.children == Level::Children::kLooseLeaves) {
      for (std::uint32_t i = 0; i < children.count && entry_of(children.keys[i]) <= limit; ++i) {
        const std::uint32_t child = children.keys[i] & 15;
        if (!visitor.visit_leaf(level, node, child, level.child_x(at.x, child), level.child_y(at.y, child)))
          continue;
        if (visitor.is_over()) return;
        limit = visitor.limit();
      }
    } else {
      for (std::uint32_t i = children.count; i-- > 0;) push(level, at, children.keys[i]);
    }
  }
}

inline void find_nearest(const TreeView& view, const Ray& ray, Hit& best) {
  const ShearedRay sheared(ray);
  CullingRay culling;
  switch (reach(ray, sheared, *view.tree, culling)) {
    case Reach::kMisses:
      return;
    case Reach::kUnusual:
      return LinearScan(*view.mesh).find_nearest(ray, view.object, best);
    case Reach::kMayHit:
      break;
  }
  NearestSearch search{best};
  RayVisitor<NearestSearch> visitor{view, ray, sheared, culling, search};
  search_tree(*view.tree, visitor);
}

inline bool is_blocked(const TreeView& view, const Ray& ray, double end) {
  const ShearedRay sheared(ray);
  CullingRay culling;
  switch (reach(ray, sheared, *view.tree, culling)) {
    case Reach::kMisses:
      return false;
    case Reach::kUnusual:
      return LinearScan(*view.mesh).is_blocked(ray, view.object, end);
    case Reach::kMayHit:
      break;
  }
  AnySearch search{end};
  RayVisitor<AnySearch> visitor{view, ray, sheared, culling, search};
  search_tree(*view.tree, visitor);
  return search.is_found;
}

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
