// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ray.hpp"

namespace sweepkit::render {

struct Box {
  glm::dvec3 low{kNoEnd};
  glm::dvec3 high{-kNoEnd};

  void add(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
};

/// A box divided into equal voxels, each with a list of items: the spatially enumerated auxiliary data
/// structure (SEADS) of Fujimoto, Tanaka, Iwata (1986). Lists lie one after another: those of voxel k are
/// items[first[k]] .. items[first[k+1]-1].
struct VoxelGrid {
  Box box;
  glm::ivec3 count{1};
  glm::dvec3 cell{1.0};
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> items;

  std::size_t voxel_count() const { return static_cast<std::size_t>(count.x) * count.y * count.z; }
  std::size_t index(const glm::ivec3& at) const {
    return (static_cast<std::size_t>(at.z) * count.y + at.y) * count.x + at.x;
  }
  /// The voxel that holds `point`; for a point outside, or one that is no number, the nearest or any.
  glm::ivec3 voxel_of(const glm::dvec3& point) const {
    glm::ivec3 at(0);
    for (int axis = 0; axis < 3; ++axis) {
      const double cells = (point[axis] - box.low[axis]) / cell[axis];
      // Clamped before the conversion, which has no result for a number too large.
      if (cells >= 1) at[axis] = cells < count[axis] ? static_cast<int>(cells) : count[axis] - 1;
    }
    return at;
  }
  std::size_t bytes() const { return (first.size() + items.size()) * sizeof(std::uint32_t); }
};

/// A grid over `box` whose voxels are cubes about `side` wide, at most `most_voxels` of them. The box is
/// enlarged by a billionth of its size: far more than rounding moves a point, far less than a voxel.
inline VoxelGrid make_grid(Box box, double side, double most_voxels) {
  VoxelGrid grid;
  const glm::dvec3 size = box.high - box.low;
  const double extent = std::max({size.x, size.y, size.z});
  const double margin =
      1e-9 * (extent + std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.low.z)}));
  grid.box = {box.low - margin, box.high + margin};
  const glm::dvec3 whole = grid.box.high - grid.box.low;
  const double fewest = std::cbrt(whole.x * whole.y * whole.z / most_voxels);
  const double h = std::max(side, fewest);
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = h > 0 ? whole[axis] / h : 1;
    grid.count[axis] = static_cast<int>(std::clamp(std::round(cells), 1.0, 1024.0));
    grid.cell[axis] = whole[axis] / grid.count[axis];
  }
  return grid;
}

/// Puts items 0..n-1 into every voxel of their boxes for which `overlap_of(item, half)(middle)` holds: half
/// the size of a voxel, and its middle. An item's voxels hold it in ascending order.
template <class BoxOf, class OverlapOf>
void fill_grid(VoxelGrid& grid, std::uint32_t n, BoxOf&& box_of, OverlapOf&& overlap_of) {
  const double slack =
      1e-9 * std::max({grid.cell.x * grid.count.x, grid.cell.y * grid.count.y, grid.cell.z * grid.count.z});
  const glm::dvec3 half = 0.5 * grid.cell + slack;
  // The voxels of all items, one item's after another's, and how many an item has: looked for once, since
  // that is the most of the work.
  std::vector<std::uint32_t> voxels;
  std::vector<std::uint32_t> ends(n);
  voxels.reserve(3 * static_cast<std::size_t>(n));
  grid.first.assign(grid.voxel_count() + 1, 0);
  for (std::uint32_t item = 0; item < n; ++item) {
    const Box box = box_of(item);
    const glm::ivec3 from = grid.voxel_of(box.low - slack);
    const glm::ivec3 to = grid.voxel_of(box.high + slack);
    const glm::ivec3 extent = to - from + 1;
    const auto use = [&](int x, int y, int z) {
      const auto voxel = static_cast<std::uint32_t>(grid.index({x, y, z}));
      voxels.push_back(voxel);
      ++grid.first[voxel];
    };
    // One or two voxels are taken without a closer look.
    if (extent.x * extent.y * extent.z <= 2) {
      use(from.x, from.y, from.z);
      if (from != to) use(to.x, to.y, to.z);
    } else {
      const auto overlaps = overlap_of(item, half);
      for (int z = from.z; z <= to.z; ++z) {
        for (int y = from.y; y <= to.y; ++y) {
          for (int x = from.x; x <= to.x; ++x) {
            if (overlaps(grid.box.low + (glm::dvec3(x, y, z) + 0.5) * grid.cell)) use(x, y, z);
          }
        }
      }
    }
    ends[item] = static_cast<std::uint32_t>(voxels.size());
  }
  // Each voxel's end for now; filled from the back, that becomes its first.
  for (std::size_t i = 1; i < grid.first.size(); ++i) grid.first[i] += grid.first[i - 1];
  grid.items.resize(voxels.size());
  for (std::uint32_t item = n; item-- > 0;) {
    for (std::uint32_t i = item == 0 ? 0 : ends[item - 1]; i < ends[item]; ++i)
      grid.items[--grid.first[voxels[i]]] = item;
  }
}

/// The voxels along a ray in order, by the 3D digital differential analyzer. Departs from the paper's, which
/// counts in integers, in Amanatides and Woo's (1987) form in double: a ray here starts anywhere and t is
/// wanted. Rules: a direction component of 0 (or -0) never steps; each boundary's t comes from the voxel's
/// index, not from a running sum; the walk ends when an index leaves the grid, so it always ends.
/// `visit(voxel, t where the ray leaves it)` returns true to stop.
template <class Visit>
void walk(const VoxelGrid& grid, const Ray& ray, double end, Visit&& visit) {
  double enter = 0;
  double leave = end;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    if (d == 0) {
      if (!(ray.origin[axis] >= grid.box.low[axis] && ray.origin[axis] <= grid.box.high[axis])) return;
      continue;
    }
    double near = (grid.box.low[axis] - ray.origin[axis]) / d;
    double far = (grid.box.high[axis] - ray.origin[axis]) / d;
    if (d < 0) std::swap(near, far);
    if (!(near <= far)) return;  // no numbers
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  if (!(enter <= leave && enter < kNoEnd)) return;

  glm::ivec3 at = grid.voxel_of(ray.origin + enter * ray.direction);
  std::array<int, 3> step;
  std::array<double, 3> next;
  const auto boundary = [&](int axis) {
    const double plane = grid.box.low[axis] +
                         (at[axis] + (step[static_cast<std::size_t>(axis)] > 0 ? 1 : 0)) * grid.cell[axis];
    return (plane - ray.origin[axis]) / ray.direction[axis];
  };
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    step[static_cast<std::size_t>(axis)] = d > 0 ? 1 : d < 0 ? -1 : 0;
    next[static_cast<std::size_t>(axis)] = d == 0 ? kNoEnd : boundary(axis);
  }
  while (true) {
    const int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    const auto a = static_cast<std::size_t>(axis);
    const double exit = next[a];
    if (visit(grid.index(at), exit)) return;
    if (step[a] == 0 || exit > end) return;
    at[axis] += step[a];
    if (at[axis] < 0 || at[axis] >= grid.count[axis]) return;
    next[a] = boundary(axis);
  }
}

}  // namespace sweepkit::render
