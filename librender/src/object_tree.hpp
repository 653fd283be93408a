// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

#include "ray.hpp"
#include "voxel_grid.hpp"

namespace sweepkit::render {

/// A tree of boxes over the objects of a scene: which of them a ray may meet. Flat, two children a node, one
/// object a leaf; 56 bytes an object.
class ObjectTree {
 public:
  /// The most rays that walk it together.
  static constexpr std::size_t kMostRays = 16;

  ObjectTree() = default;
  /// Boxes in the world, by object; `objects` are those that can be met, in ascending order. `rounding` is
  /// how far a point of an object may be found outside of its box, as a share of the coordinates that took
  /// part: those of the ray's origin twice, and `reach`, the largest of any box and object.
  ObjectTree(std::span<const Box> boxes, std::vector<std::uint32_t> objects, double rounding, double reach);

  std::size_t bytes() const { return nodes_.size() * sizeof(Node); }

  /// Calls on_object(index) for every object whose box the ray meets at 0 <= t <= end, roughly the nearer
  /// before the farther; it may lower `end` meanwhile, and returns true to stop.
  template <class OnObject>
  void walk(const Ray& ray, const double& end, OnObject&& on_object) const;

  /// The same for rays of one origin, at most kMostRays: on_object(index, mask) with bit i set where ray i
  /// meets the box at 0 <= t <= end(i).
  template <class End, class OnObject>
  void walk(std::span<const Ray> rays, End&& end, OnObject&& on_object) const;

 private:
  // Each child with its box: `children` is a node's index, or the complement of an object's.
  struct Node {
    std::array<std::array<float, 3>, 2> low;
    std::array<std::array<float, 3>, 2> high;
    std::array<std::int32_t, 2> children;
  };
  // The splits by the heuristic, and then as many as halve 2^32 objects.
  static constexpr std::size_t kDeepest = 48 + 32;
  static constexpr int kMostHeuristicSplits = 48;

  struct Builder;

  // What every slab test of an origin needs: a plane p is reached at (p - origin) / direction.
  struct Start {
    glm::dvec3 low;   // the origin moved up by the slack: what a box's lower planes are measured from
    glm::dvec3 high;  // and down, for the upper ones
  };
  Start start_of(const glm::dvec3& origin) const;
  static glm::dvec3 inverse_of(const glm::dvec3& direction);

  bool meets(const Node& node, std::size_t child, const Start& start, const glm::dvec3& inverse, double end,
             double& near) const {
    near = 0;
    double far = end;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double low = (static_cast<double>(node.low[child][a]) - start.low[axis]) * inverse[axis];
      const double high = (static_cast<double>(node.high[child][a]) - start.high[axis]) * inverse[axis];
      near = std::max(near, std::min(low, high));
      far = std::min(far, std::max(low, high));
    }
    return near <= far;
  }

  std::vector<Node> nodes_;  // a node before its children; none for fewer than two objects
  std::int32_t root_ = 0;    // as a child is
  bool is_empty_ = true;
  glm::dvec3 middle_{0.0};  // boxes are kept relative to it, where float32 is finest
  double rounding_ = 0;
  double reach_ = 0;
};

inline ObjectTree::Start ObjectTree::start_of(const glm::dvec3& origin) const {
  const glm::dvec3 size = glm::abs(origin);
  const double slack = rounding_ * (2 * std::max({size.x, size.y, size.z}) + reach_);
  const glm::dvec3 from = origin - middle_;
  return {from + slack, from - slack};
}

// A direction of 0 never comes to a plane that it is not within the slack of already; the largest number is
// as good as infinity, and its product with 0 is one.
inline glm::dvec3 ObjectTree::inverse_of(const glm::dvec3& direction) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  glm::dvec3 inverse;
  for (int axis = 0; axis < 3; ++axis) {
    const double exact = 1 / direction[axis];
    inverse[axis] = std::abs(exact) <= kLargest ? exact : std::copysign(kLargest, direction[axis]);
  }
  return inverse;
}

template <class OnObject>
void ObjectTree::walk(const Ray& ray, const double& end, OnObject&& on_object) const {
  if (is_empty_) return;
  if (root_ < 0) {
    on_object(static_cast<std::uint32_t>(~root_));
    return;
  }
  const Start start = start_of(ray.origin);
  const glm::dvec3 inverse = inverse_of(ray.direction);
  // No numbers: they would compare false with every box and be sent everywhere.
  if (!(glm::dot(start.low, start.low) < kNoEnd && glm::dot(ray.direction, ray.direction) < kNoEnd)) return;
  struct Entry {
    std::int32_t child;
    double near;
  };
  std::array<Entry, kDeepest + 2> stack;
  std::size_t count = 0;
  Entry at{root_, 0};
  while (true) {
    if (at.near <= end) {
      if (at.child < 0) {
        if (on_object(static_cast<std::uint32_t>(~at.child))) return;
      } else {
        const Node& node = nodes_[static_cast<std::size_t>(at.child)];
        std::array<double, 2> near;
        const bool meets_first = meets(node, 0, start, inverse, end, near[0]);
        const bool meets_second = meets(node, 1, start, inverse, end, near[1]);
        if (meets_first && meets_second) {
          const std::size_t farther = near[1] < near[0] ? 0 : 1;
          stack[count++] = {node.children[farther], near[farther]};
          at = {node.children[1 - farther], near[1 - farther]};
          continue;
        }
        if (meets_first || meets_second) {
          const std::size_t only = meets_first ? 0 : 1;
          at = {node.children[only], near[only]};
          continue;
        }
      }
    }
    if (count == 0) return;
    at = stack[--count];
  }
}

template <class End, class OnObject>
void ObjectTree::walk(std::span<const Ray> rays, End&& end, OnObject&& on_object) const {
  if (is_empty_ || rays.empty()) return;
  const Start start = start_of(rays[0].origin);
  std::array<glm::dvec3, kMostRays> inverse;
  std::uint32_t all = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    inverse[i] = inverse_of(rays[i].direction);
    const bool has_numbers =
        glm::dot(start.low, start.low) < kNoEnd && glm::dot(rays[i].direction, rays[i].direction) < kNoEnd;
    if (has_numbers) all |= 1u << i;
  }
  if (all == 0) return;
  struct Entry {
    std::int32_t child;
    std::uint32_t mask;
  };
  std::array<Entry, kDeepest + 2> stack;
  std::size_t count = 0;
  Entry at{root_, all};
  while (true) {
    if (at.child < 0) {
      on_object(static_cast<std::uint32_t>(~at.child), at.mask);
    } else {
      const Node& node = nodes_[static_cast<std::size_t>(at.child)];
      std::array<std::uint32_t, 2> mask{};
      std::array<double, 2> first{kNoEnd, kNoEnd};  // where any ray comes to the child
      for (std::uint32_t left = at.mask; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        for (std::size_t child = 0; child < 2; ++child) {
          double near = 0;
          if (!meets(node, child, start, inverse[i], end(i), near)) continue;
          mask[child] |= 1u << i;
          first[child] = std::min(first[child], near);
        }
      }
      const std::size_t farther = first[1] < first[0] ? 0 : 1;
      if (mask[farther] != 0) stack[count++] = {node.children[farther], mask[farther]};
      if (mask[1 - farther] != 0) stack[count++] = {node.children[1 - farther], mask[1 - farther]};
    }
    if (count == 0) return;
    at = stack[--count];
  }
}

}  // namespace sweepkit::render
