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
  std::uint32_t keys[kWidth];
};

HWY_INLINE float entry_of(std::uint32_t key) { return std::bit_cast<float>(key & ~15u); }

/// The children whose boxes the ray passes between 0 and `limit`.
HWY_INLINE void enter(const BoxNode& node, const CullingRay& ray, float limit, Children& children) {
  const float* planes = node.low[0];
  Lanes enter = set(0.0F);
  Lanes leave = set(limit);
  for (int axis = 0; axis < 3; ++axis) {
    const Lanes inverse = set(ray.inverse[axis]);
    enter = max(multiply_add(load(planes + ray.near_plane[axis]), inverse, set(ray.near_shift[axis])), enter);
    leave = min(multiply_add(load(planes + ray.far_plane[axis]), inverse, set(ray.far_shift[axis])), leave);
  }
  std::uint32_t bits = less_equal(enter, leave);
  children.count = 0;
  if (bits == 0) return;
  alignas(64) float entries[kWidth];
  store(enter, entries);
  do {
    const auto child = static_cast<std::uint32_t>(std::countr_zero(bits));
    bits &= bits - 1;
    const std::uint32_t key = (std::bit_cast<std::uint32_t>(entries[child]) & ~15u) | child;
    std::uint32_t at = children.count++;
    for (; at > 0 && children.keys[at - 1] > key; --at) children.keys[at] = children.keys[at - 1];
    children.keys[at] = key;
  } while (bits != 0);
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

// A node leaves at most 15 children waiting; there are at most 8 levels of 16 over 2^32 leaves, and as many
// over the entries.
inline constexpr std::size_t kMostWaiting = 16 * 16;

template <class Search>
HWY_INLINE void search_tree(const TreeView& view, const Ray& ray, const ShearedRay& sheared,
                            const CullingRay& culling, Search& search) {
  const BoxTree& tree = *view.tree;
  const Level* const levels = tree.levels.data();
  Waiting waiting[kMostWaiting];
  std::size_t count = 0;
  const auto roots = static_cast<std::uint32_t>(tree.levels.size() - 1);
  for (std::uint32_t root = levels[roots].columns; root-- > 1;) waiting[count++] = {0, {roots, root, 0}};
  Place at = {roots, 0, 0};
  float limit = culling.limit(search.end());
  while (true) {
    const Level& level = levels[at.level];
    const BoxNode& node = tree.nodes[level.first_node + at.y * level.columns + at.x];
    Children children;
    enter(node, culling, limit, children);
    if (level.children == Level::Children::kGridLeaves || level.children == Level::Children::kLooseLeaves) {
      for (std::uint32_t i = 0; i < children.count && entry_of(children.keys[i]) <= limit; ++i) {
        const std::uint32_t child = children.keys[i] & 15;
        if (search_leaf(view, level, level.child_x(at.x, child), level.child_y(at.y, child),
                        extent_of(node, child), ray, sheared, culling, search)) {
          return;
        }
        limit = culling.limit(search.end());
      }
    } else if (children.count > 0) {
      for (std::uint32_t i = children.count; i-- > 0;) {
        const std::uint32_t child = children.keys[i] & 15;
        Waiting& next = waiting[count++];
        next.key = children.keys[i];
        next.place = level.children == Level::Children::kEntries
                         ? tree.entries[kWidth * at.x + child]
                         : Place{at.level - 1, level.child_x(at.x, child), level.child_y(at.y, child)};
      }
    }
    do {
      if (count == 0) return;
      --count;
    } while (entry_of(waiting[count].key) > limit);
    at = waiting[count].place;
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
  search_tree(view, ray, sheared, culling, search);
}

inline void find_nearest_packet(const TreeView& view, std::span<const Ray> rays, std::span<Hit> best) {
  for (std::size_t i = 0; i < rays.size(); ++i) find_nearest(view, rays[i], best[i]);
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
  search_tree(view, ray, sheared, culling, search);
  return search.is_found;
}

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
