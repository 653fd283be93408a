// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "voxel_grid.hpp"

namespace sweepkit::render {

/// 0..count-1, sorted along the Z curve through `box` by point_of(i): neighbours in the order are mostly
/// neighbours in space (Morton 1966). Points that are no number come anywhere.
template <class PointOf>
std::vector<std::uint32_t> morton_order(std::uint32_t count, const Box& box, PointOf&& point_of) {
  constexpr double kCells = 1024;
  const glm::dvec3 size = box.high - box.low;
  std::vector<std::uint64_t> keys(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::dvec3 point = point_of(i);
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = kCells * (point[axis] - box.low[axis]) / size[axis];
      const auto at = cell >= 1 ? static_cast<std::uint64_t>(std::min(cell, kCells - 1)) : 0;
      for (int bit = 0; bit < 10; ++bit) key |= (at >> bit & 1) << (3 * bit + axis);
    }
    keys[i] = key << 32 | i;
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(count);
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  return order;
}

}  // namespace sweepkit::render
