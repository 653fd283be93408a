// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "voxel_grid.hpp"

namespace sweepkit::render {

inline VoxelGrid grid_of(const glm::ivec3& count,
                         const Box& box = {glm::dvec3(-1, 2, 0.5), glm::dvec3(3, 5, 0.75)}) {
  VoxelGrid grid;
  grid.box = box;
  grid.count = count;
  grid.cell = (grid.box.high - grid.box.low) / glm::dvec3(count);
  return grid;
}

/// The voxels that the ray passes, every box tested by itself; each made smaller by `shrink` of a voxel on
/// every side.
inline std::vector<bool> enumerated(const VoxelGrid& grid, const Ray& ray, double shrink) {
  std::vector<bool> voxels(grid.voxel_count());
  for (int z = 0; z < grid.count.z; ++z) {
    for (int y = 0; y < grid.count.y; ++y) {
      for (int x = 0; x < grid.count.x; ++x) {
        const glm::dvec3 low = grid.box.low + glm::dvec3(x, y, z) * grid.cell + shrink * grid.cell;
        const glm::dvec3 high = low + (1 - 2 * shrink) * grid.cell;
        double enter = 0;
        double leave = kNoEnd;
        for (int axis = 0; axis < 3; ++axis) {
          if (ray.direction[axis] == 0) {
            if (ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis]) leave = -1;
            continue;
          }
          const double a = (low[axis] - ray.origin[axis]) / ray.direction[axis];
          const double b = (high[axis] - ray.origin[axis]) / ray.direction[axis];
          enter = std::max(enter, std::min(a, b));
          leave = std::min(leave, std::max(a, b));
        }
        if (enter <= leave) voxels[grid.index({x, y, z})] = true;
      }
    }
  }
  return voxels;
}

/// The walk visits, once each and in order, all voxels that the ray surely passes and none that it surely
/// misses: those that are a billionth smaller, and larger.
inline void expect_walk_agrees(const VoxelGrid& grid, const Ray& ray) {
  std::vector<bool> walked(grid.voxel_count());
  double before = 0;
  walk(grid, ray, kNoEnd, [&](std::size_t voxel, double exit) {
    EXPECT_GE(exit, before - 1e-9);
    before = exit;
    EXPECT_FALSE(walked[voxel]) << "a voxel was visited twice";
    walked[voxel] = true;
    return false;
  });
  const std::vector<bool> certain = enumerated(grid, ray, 1e-9);
  const std::vector<bool> possible = enumerated(grid, ray, -1e-9);
  for (std::size_t voxel = 0; voxel < walked.size(); ++voxel) {
    ASSERT_TRUE(walked[voxel] || !certain[voxel]);
    ASSERT_TRUE(possible[voxel] || !walked[voxel]);
  }
}

}  // namespace sweepkit::render
