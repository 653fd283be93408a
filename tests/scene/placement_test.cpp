// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>

#include "sweepkit/scene/camera.hpp"
#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {
namespace {

glm::dvec3 moved(const Placement& placement, glm::dvec3 point) {
  return glm::dvec3(to_matrix(placement) * glm::dvec4(point, 1));
}

TEST(Placement, ScalesThenRotatesThenTranslates) {
  // (1,0,0) -> scaled (2,0,0) -> about z by 90 degrees (0,2,0) -> moved.
  EXPECT_EQ(moved({{10, 20, 30}, {0, 0, 90}, {2, 3, 4}}, {1, 0, 0}), glm::dvec3(10, 22, 30));
}

TEST(Placement, RotatesAboutTheFixedAxesXThenYThenZ) {
  // (0,1,0) about x by 90 is (0,0,1), then about y by 90 (1,0,0), then about z by 90 (0,1,0).
  EXPECT_EQ(moved({{}, {90, 90, 90}, glm::dvec3(1)}, {0, 1, 0}), glm::dvec3(0, 1, 0));
  EXPECT_EQ(moved({{}, {90, 90, 0}, glm::dvec3(1)}, {0, 1, 0}), glm::dvec3(1, 0, 0));
}

TEST(Placement, QuarterTurnsAreExactHoweverMany) {
  for (const double turns : {-9, -2, -1, 3, 5, 400000001}) {
    const glm::dmat4 matrix = to_matrix({{}, {90 * turns, -90 * turns, 90 * turns}, glm::dvec3(1)});
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        const double entry = std::abs(matrix[column][row]);
        EXPECT_TRUE(entry == 0 || entry == 1) << turns << ": " << entry;
      }
    }
    EXPECT_EQ(glm::determinant(matrix), 1);
  }
}

TEST(Placement, OtherTurnsAreRotations) {
  const glm::dmat3 matrix(to_matrix({{}, {17, -123, 555.5}, glm::dvec3(1)}));
  const glm::dmat3 identity = glm::transpose(matrix) * matrix;
  // Each entry is a sum of three products of three cosines: a few units in the last place of 1.
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(identity[i][j], i == j ? 1 : 0, 1e-15);
  }
}

TEST(Camera, AxesAreRightHandedAndLookAtTheTarget) {
  const Camera camera{{3, 4, 5}, {1, 0, -2}, {0, 1, 0}, 40};
  const glm::dmat3 axes = world_from_camera(camera);
  EXPECT_NEAR(glm::determinant(axes), 1, 1e-15);
  EXPECT_NEAR(glm::distance(axes[2], glm::normalize(camera.eye - camera.target)), 0, 1e-15);
  EXPECT_GT(axes[1].y, 0);
  EXPECT_NEAR(axes[0].y, 0, 1e-15) << "level where up is +Y";
}

TEST(Camera, LookingAlongUpHasATopToo) {
  EXPECT_EQ(world_from_camera({{0, 5, 0}, {0, 0, 0}, {0, 1, 0}, 40})[1], glm::dvec3(0, 0, -1));
  EXPECT_EQ(world_from_camera({{0, 0, 5}, {0, 0, 0}, {0, 0, 1}, 40})[1], glm::dvec3(0, 1, 0));
}

}  // namespace
}  // namespace sweepkit::scene
