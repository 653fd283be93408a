// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "voxel_grid.hpp"

namespace sweepkit::render {
namespace {

VoxelGrid grid_of(const glm::ivec3& count) {
  VoxelGrid grid;
  grid.box = {glm::dvec3(-1, 2, 0.5), glm::dvec3(3, 5, 0.75)};
  grid.count = count;
  grid.cell = (grid.box.high - grid.box.low) / glm::dvec3(count);
  return grid;
}

// The voxels a ray has inside it for longer than rounding: every box tested by itself.
std::set<std::size_t> enumerated(const VoxelGrid& grid, const Ray& ray, double shrink) {
  std::set<std::size_t> voxels;
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
        if (enter <= leave) voxels.insert(grid.index({x, y, z}));
      }
    }
  }
  return voxels;
}

void expect_walk_agrees(const VoxelGrid& grid, const Ray& ray) {
  std::vector<std::size_t> walked;
  double before = 0;
  walk(grid, ray, kNoEnd, [&](std::size_t voxel, double exit) {
    EXPECT_GE(exit, before - 1e-9);
    before = exit;
    walked.push_back(voxel);
    return false;
  });
  const std::set<std::size_t> visited(walked.begin(), walked.end());
  ASSERT_EQ(visited.size(), walked.size()) << "a voxel was visited twice";
  // All that the ray surely passes, and none that it surely misses: voxels shrunk and swollen by a billionth.
  for (const std::size_t voxel : enumerated(grid, ray, 1e-9)) ASSERT_TRUE(visited.contains(voxel));
  const std::set<std::size_t> possible = enumerated(grid, ray, -1e-9);
  for (const std::size_t voxel : visited) ASSERT_TRUE(possible.contains(voxel));
}

TEST(VoxelWalk, VisitsWhatAnEnumerationOfAllVoxelsFinds) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> real(-1, 1);
  const VoxelGrid grid = grid_of({7, 5, 3});
  for (int n = 0; n < 100000; ++n) {
    const glm::dvec3 direction(real(random), real(random), real(random));
    const glm::dvec3 through =
        grid.box.low +
        (glm::dvec3(real(random), real(random), real(random)) * 0.6 + 0.5) * (grid.box.high - grid.box.low);
    expect_walk_agrees(grid, {through - 10.0 * direction * std::abs(real(random)), direction});
  }
}

TEST(VoxelWalk, AgreesOnAxisParallelRaysWithEitherZero) {
  const VoxelGrid grid = grid_of({4, 3, 2});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> real(0, 1);
  for (int n = 0; n < 20000; ++n) {
    const int axis = n % 3;
    glm::dvec3 direction(n % 2 == 0 ? 0.0 : -0.0);
    direction[axis] = n % 4 < 2 ? 1 : -1;
    glm::dvec3 origin =
        grid.box.low + glm::dvec3(real(random), real(random), real(random)) * (grid.box.high - grid.box.low);
    // Half of them run exactly along planes between voxels.
    if (n % 8 < 4) origin[(axis + 1) % 3] = grid.box.low[(axis + 1) % 3] + grid.cell[(axis + 1) % 3];
    origin[axis] = direction[axis] > 0 ? -100 : 100;
    expect_walk_agrees(grid, {origin, direction});
  }
}

TEST(VoxelWalk, AgreesOnDiagonalsThroughTheCornersOfVoxels) {
  VoxelGrid grid;
  grid.box = {glm::dvec3(0.0), glm::dvec3(4.0)};
  grid.count = {4, 4, 4};
  grid.cell = glm::dvec3(1.0);
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      for (const double sz : {-1.0, 1.0}) {
        const glm::dvec3 direction(sx, sy, sz);
        expect_walk_agrees(grid, {glm::dvec3(2.0) - 7.0 * direction, direction});
      }
    }
  }
}

TEST(VoxelWalk, StopsWhenToldAndAtTheEnd) {
  const VoxelGrid grid = grid_of({8, 1, 1});
  const Ray ray{{-5, 3, 0.6}, {1, 0, 0}};
  int visits = 0;
  walk(grid, ray, kNoEnd, [&](std::size_t, double) { return ++visits == 3; });
  EXPECT_EQ(visits, 3);
  visits = 0;
  walk(grid, ray, 5.2,
       [&](std::size_t, double) { return ++visits == 100; });  // 1.2 into the box: voxels of 0.5
  EXPECT_EQ(visits, 3);
  walk(grid, {{-5, 3, 0.9}, {1, 0, 0}}, kNoEnd, [](std::size_t, double) {
    ADD_FAILURE() << "this ray misses the box";
    return true;
  });
}

}  // namespace
}  // namespace sweepkit::render
