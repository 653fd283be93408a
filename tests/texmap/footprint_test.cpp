// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/footprint.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace sweepkit::texmap {
namespace {

TEST(NeighbourBox, BoundsTheHitAndItsNeighbours) {
  const std::vector<glm::dvec2> around = {{0.4, 0.5}, {0.6, 0.45}, {0.5, 0.7}};
  const UvBox box = neighbour_box({0.5, 0.5}, around, {0, 0});
  EXPECT_EQ(box.min, glm::dvec2(0.4, 0.45));
  EXPECT_EQ(box.max, glm::dvec2(0.6, 0.7));
}

TEST(NeighbourBox, StepsOverASeamToTheNearestRepresentative) {
  const UvBox box = neighbour_box({0.98, 0.5}, std::vector<glm::dvec2>{{0.01, 0.5}, {0.95, 0.5}}, {1, 0});
  EXPECT_DOUBLE_EQ(box.min.x, 0.95);
  EXPECT_DOUBLE_EQ(box.max.x, 1.01);
}

TEST(NeighbourBox, DoesNotStepWhereNothingComesRound) {
  const UvBox box = neighbour_box({0.98, 0.5}, std::vector<glm::dvec2>{{0.01, 0.5}}, {0, 0});
  EXPECT_EQ(box.min.x, 0.01);
}

TEST(NeighbourBox, KeepsABoxWideThatIsWideForAReason) {
  // A quarter of four repeats is one whole texture: it must not shrink to nothing.
  const UvBox box = neighbour_box({1, 0}, std::vector<glm::dvec2>{{0, 0}, {2, 0}}, {4, 0});
  EXPECT_EQ(box.max.x - box.min.x, 2);
}

TEST(NeighbourBox, PassesOverNeighboursThatAreNoNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const glm::dvec2 period : {glm::dvec2(0, 0), glm::dvec2(1, 1)}) {
    const UvBox box = neighbour_box({0.5, 0.5}, std::vector<glm::dvec2>{{nan, 0}, {0, infinity}}, period);
    EXPECT_EQ(box.min, glm::dvec2(0.5, 0.5));
    EXPECT_EQ(box.max, glm::dvec2(0.5, 0.5));
  }
}

TEST(Shrunk, HalvesABoxAboutItsHit) {
  const UvBox box = shrunk({{0, 0}, {4, 2}}, {1, 1}, 0.5);
  EXPECT_EQ(box.min, glm::dvec2(0.5, 0.5));
  EXPECT_EQ(box.max, glm::dvec2(2.5, 1.5));
}

}  // namespace
}  // namespace sweepkit::texmap
