// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "voxel_enumeration.hpp"

namespace sweepkit::render {
namespace {

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
