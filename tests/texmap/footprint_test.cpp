// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/footprint.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>
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

// The covariance of a footprint's tent, whose variance is 1/6 a squared step.
glm::dmat2 covariance(const Footprint& f) {
  return (glm::outerProduct(f.dx, f.dx) + glm::outerProduct(f.dy, f.dy)) / 6.0;
}

TEST(CutAlongMajor, KeepsTheMeanAndTheCovariance) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> real(-1, 1);
  std::array<FootprintPart, 16> parts;
  int cut = 0;
  for (int n = 0; n < 1000; ++n) {
    const Footprint whole{
        {real(random), real(random)}, {real(random), real(random)}, {real(random), real(random)}};
    const int count = cut_along_major(whole, 16, parts);
    cut += count > 1 ? 1 : 0;
    double weight = 0;
    glm::dvec2 mean(0.0);
    glm::dmat2 spread(0.0);
    for (int i = 0; i < count; ++i) {
      const FootprintPart& part = parts[static_cast<std::size_t>(i)];
      const glm::dvec2 offset = part.footprint.uv - whole.uv;
      weight += part.weight;
      mean += part.weight * offset;
      spread += part.weight * (covariance(part.footprint) + glm::outerProduct(offset, offset));
    }
    EXPECT_NEAR(weight, 1, 1e-14);
    EXPECT_NEAR(glm::length(mean), 0, 1e-14);
    const glm::dmat2 expected = covariance(whole);
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) EXPECT_NEAR(spread[i][j], expected[i][j], 1e-14);
    }
  }
  EXPECT_GT(cut, 300);
}

TEST(CutAlongMajor, LeavesOneWhereThereIsNothingToCut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<FootprintPart, 8> parts;
  for (const Footprint& f :
       {Footprint{{0.5, 0.5}}, Footprint{{0.5, 0.5}, {1, 0}, {0, 1}}, Footprint{{0.5, 0.5}, {nan, 0}, {0, 1}},
        Footprint{{0.5, 0.5}, {infinity, 0}, {0, 1}}}) {
    EXPECT_EQ(cut_along_major(f, 8, parts), 1);
    EXPECT_EQ(parts[0].weight, 1);
    EXPECT_EQ(parts[0].footprint.uv, f.uv);
  }
  // A line without width is cut as often as it may be.
  EXPECT_EQ(cut_along_major({{0.5, 0.5}, {1, 1}, {0, 0}}, 8, parts), 8);
}

TEST(FootprintFromDerivatives, IsTheAffineMapOfTheTriangle) {
  // Steps made of the triangle's own edges, wherever it lies and however it is turned: (u,v) moves by as much
  // of its edges.
  std::mt19937 random(2);
  std::uniform_real_distribution<double> real(-1, 1);
  const auto point = [&] { return glm::dvec3(real(random), real(random), real(random)); };
  for (const double distance : {0.0, 1e6}) {
    for (int n = 0; n < 1000; ++n) {
      const glm::dvec3 far = distance * point();
      const Triangle3<double> triangle{far + point(), far + point(), far + point()};
      const glm::dvec3 ba = triangle.a - triangle.b;
      const glm::dvec3 bc = triangle.c - triangle.b;
      const double height = glm::length(glm::cross(ba, bc));
      if (height < 0.05) continue;
      const std::array<glm::dvec2, 3> uv = {glm::dvec2(real(random), real(random)),
                                            glm::dvec2(real(random), real(random)),
                                            glm::dvec2(real(random), real(random))};
      const double p = real(random);
      const double q = real(random);
      const Footprint f = footprint_from(triangle, uv, {0.3, 0.4}, p * ba + q * bc, bc);
      // Two areas of a plane that holds at least 1/sqrt(3) of the triangle's, each of 8 roundings, over it.
      const double bound = 32 * 2.3e-16 * 8 / height;
      EXPECT_LE(glm::length(f.dx - (p * (uv[0] - uv[1]) + q * (uv[2] - uv[1]))), bound);
      EXPECT_LE(glm::length(f.dy - (uv[2] - uv[1])), bound);
      EXPECT_EQ(f.uv, glm::dvec2(0.3, 0.4));
    }
  }
}

TEST(FootprintFromDerivatives, HasNoAreaOnATriangleWithoutArea) {
  const std::array<glm::dvec2, 3> uv = {glm::dvec2(0, 1), glm::dvec2(0, 0), glm::dvec2(1, 0)};
  const Triangle3<double> line{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
  const Footprint f = footprint_from(line, uv, {0.3, 0.4}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(f.dx, glm::dvec2(0.0));
  EXPECT_EQ(f.dy, glm::dvec2(0.0));
}

TEST(Shrunk, HalvesABoxAboutItsHit) {
  const UvBox box = shrunk({{0, 0}, {4, 2}}, {1, 1}, 0.5);
  EXPECT_EQ(box.min, glm::dvec2(0.5, 0.5));
  EXPECT_EQ(box.max, glm::dvec2(2.5, 1.5));
}

}  // namespace
}  // namespace sweepkit::texmap
