// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A million rays of the kinds that grid walks are known to fail on. The second grid's planes are whole
// numbers, so that rays run exactly along its faces, edges and corners.

#include <gtest/gtest.h>

#include <random>

#include "voxel_enumeration.hpp"

namespace sweepkit::render {
namespace {

constexpr int kRays = 1000000;

class Rays {
 public:
  explicit Rays(const VoxelGrid& grid) : grid_(grid) {}

  Ray next(int n) {
    glm::dvec3 direction(signed_real(), signed_real(), signed_real());
    switch (n % 8) {
      case 0:  // any
        return {point(1.5), direction};
      case 1:  // through a corner of voxels
        return towards(point(1.5), lattice_point());
      case 2:  // parallel to a plane or an axis, with either zero
        direction[n / 8 % 3] = zero();
        if (n % 3 == 0) direction[(n / 8 + 1) % 3] = zero();
        return {point(1), direction};
      case 3: {  // in a plane between voxels, or on the box
        const int axis = n / 8 % 3;
        glm::dvec3 origin = point(1.5);
        origin[axis] = lattice_point()[axis];
        direction[axis] = zero();
        return {origin, direction};
      }
      case 4: {  // along an edge of voxels
        const int axis = n / 8 % 3;
        direction = {zero(), zero(), zero()};
        direction[axis] = n % 16 < 8 ? 1 : -1;
        glm::dvec3 origin = lattice_point();
        origin[axis] -= 20 * direction[axis];
        return {origin, direction};
      }
      case 5: {  // from corner to corner: through edges and corners on the way
        const glm::dvec3 from = lattice_point();
        return towards(from, lattice_point());
      }
      case 6: {  // a diagonal of the voxels, from outside
        for (int axis = 0; axis < 3; ++axis)
          direction[axis] = (random_() % 2 == 0 ? 1 : -1) * grid_.cell[axis];
        return {lattice_point() - 16.0 * direction, direction};
      }
      default:  // grazing: a plane is nearly parallel
        direction[n / 8 % 3] *= 1e-12;
        return {lattice_point() - 3.0 * direction, direction};
    }
  }

 private:
  double signed_real() { return 2 * real_(random_) - 1; }
  double zero() { return random_() % 2 == 0 ? 0.0 : -0.0; }
  glm::dvec3 point(double around) {
    const glm::dvec3 share(signed_real(), signed_real(), signed_real());
    return 0.5 * (grid_.box.low + grid_.box.high) + 0.5 * around * share * (grid_.box.high - grid_.box.low);
  }
  glm::dvec3 lattice_point() {
    glm::dvec3 at;
    for (int axis = 0; axis < 3; ++axis)
      at[axis] =
          grid_.box.low[axis] +
          static_cast<double>(random_() % static_cast<unsigned>(grid_.count[axis] + 1)) * grid_.cell[axis];
    return at;
  }
  static Ray towards(const glm::dvec3& from, const glm::dvec3& to) {
    return {from, from == to ? glm::dvec3(1, 1, 0) : to - from};
  }

  const VoxelGrid& grid_;
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> real_{0, 1};
};

class AMillionRays : public testing::TestWithParam<VoxelGrid> {};

TEST_P(AMillionRays, VisitWhatAnEnumerationOfAllVoxelsFinds) {
  Rays rays(GetParam());
  for (int n = 0; n < kRays; ++n) {
    const Ray ray = rays.next(n);
    expect_walk_agrees(GetParam(), ray);
    ASSERT_FALSE(HasFailure()) << "ray " << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Walk, AMillionRays,
                         testing::Values(grid_of({7, 5, 3}),
                                         grid_of({4, 2, 5}, {glm::dvec3(-2, 0, 8), glm::dvec3(2, 2, 13)})));

}  // namespace
}  // namespace sweepkit::render
