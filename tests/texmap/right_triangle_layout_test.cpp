// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/right_triangle_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <set>

#include "mesh_shapes.hpp"

namespace sweepkit::texmap {
namespace {

using test::Shape;

RightTriangleLayout lay_out(const Shape& shape) {
  return lay_out_right_triangles(shape.positions, shape.triangles);
}

double twice_area(const std::array<glm::dvec2, 3>& p) {
  const glm::dvec2 a = p[1] - p[0];
  const glm::dvec2 b = p[2] - p[0];
  return a.x * b.y - a.y * b.x;
}

double share(const RightTriangleLayout& layout) {
  return static_cast<double>(layout.continuous_edges) / static_cast<double>(layout.interior_edges);
}

// What holds for every mesh: halves of cells, each taken once, the two of a cell along one diagonal, no
// triangle mirrored, and the letters of the paper's T2.
void expect_sound(const Shape& shape, const RightTriangleLayout& layout) {
  ASSERT_EQ(layout.halves.size(), shape.triangles.size());
  const glm::dvec2 cell = glm::dvec2(1.0) / glm::dvec2(layout.columns, layout.rows);
  std::vector<unsigned> corners(std::size_t{layout.columns} * layout.rows, 0);
  for (std::size_t t = 0; t < layout.halves.size(); ++t) {
    const HalfCell& half = layout.halves[t];
    ASSERT_LT(half.cell, corners.size());
    ASSERT_LT(half.island, layout.island_count);
    ASSERT_EQ(corners[half.cell] & 1u << half.corner, 0u);
    corners[half.cell] |= 1u << half.corner;
    const std::array<glm::dvec2, 3> uv = layout.texcoords(t);
    for (const glm::dvec2& p : uv) ASSERT_TRUE(p.x >= 0 && p.y >= 0 && p.x <= 1 && p.y <= 1);
    ASSERT_NEAR(twice_area(uv), cell.x * cell.y, 1e-12);
    const RightTriangle right = layout.right_triangle(t);
    ASSERT_EQ(right.b, uv[half.b]);
    ASSERT_NEAR(std::abs(right.bc), cell.x, 1e-12);
    ASSERT_NEAR(std::abs(right.ba), cell.y, 1e-12);
  }
  for (const unsigned taken : corners) {
    const std::set<unsigned> sound = {0, 1, 2, 4, 8, 1 | 4, 2 | 8};
    ASSERT_TRUE(sound.contains(taken)) << taken;
  }
}

// Edges that two triangles share with the same (u,v) on both sides, by a search of all pairs of triangles.
std::size_t count_continuous(const Shape& shape, const RightTriangleLayout& layout) {
  std::size_t count = 0;
  for (std::size_t s = 0; s < shape.triangles.size(); ++s) {
    for (std::size_t t = s + 1; t < shape.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 9; ++k) {
        const auto at = [&](std::size_t triangle, std::size_t corner) {
          return shape.positions[shape.triangles[triangle][corner % 3]];
        };
        const std::size_t i = k / 3;
        const std::size_t j = k % 3;
        const bool is_shared = at(s, i) == at(t, j + 1) && at(s, i + 1) == at(t, j);
        if (!is_shared) continue;
        const auto a = layout.texcoords(s);
        const auto b = layout.texcoords(t);
        if (a[i] == b[(j + 1) % 3] && a[(i + 1) % 3] == b[j]) ++count;
      }
    }
  }
  return count;
}

TEST(RightTriangleLayout, LaysEveryTriangleOnceOnARightTriangleOfTheGrid) {
  for (const Shape& shape : {test::plane(7, 5), test::torus(16, 24), test::icosphere(2),
                             test::soup_of(test::torus(9, 10)), test::plane(1, 1)}) {
    expect_sound(shape, lay_out(shape));
  }
}

TEST(RightTriangleLayout, CountsTheEdgesThatAreContinuousAsASearchOfAllPairsDoes) {
  for (const Shape& shape : {test::plane(7, 5), test::torus(8, 12), test::icosphere(1)}) {
    const RightTriangleLayout layout = lay_out(shape);
    EXPECT_EQ(layout.continuous_edges, count_continuous(shape, layout));
  }
}

TEST(RightTriangleLayout, FindsTheGridOfASquarePlaneAgainWithoutASeam) {
  const RightTriangleLayout layout = lay_out(test::plane(40, 40));
  EXPECT_EQ(layout.lone_triangles, 0u);
  EXPECT_EQ(layout.island_count, 1u);
  EXPECT_EQ(layout.interior_edges, 3u * 40 * 40 - 2 * 40);
  EXPECT_EQ(layout.continuous_edges, layout.interior_edges);
}

// A long plane cannot stay whole on a square texture: cut into strips of the texture's height it loses the
// edges of the cuts. 1000 x 10 cells in 100 x 100 make 10 strips with 9 cuts of 10 edges.
TEST(RightTriangleLayout, CutsALongPlaneIntoStrips) {
  const RightTriangleLayout layout = lay_out(test::plane(1000, 10));
  EXPECT_EQ(layout.interior_edges - layout.continuous_edges, 9u * 10);
}

// Opened along one circle each way a torus of n x m cells loses n + m of its 3 n m edges; what the square
// texture cuts off costs as much again a few times over.
TEST(RightTriangleLayout, BringsATorusBackLargelyContinuous) {
  const Shape torus = test::torus(64, 128);
  const RightTriangleLayout layout = lay_out(torus);
  EXPECT_EQ(layout.interior_edges, 3u * 64 * 128);
  EXPECT_LE(layout.interior_edges - layout.continuous_edges, 2u * (64 + 128));
}

TEST(RightTriangleLayout, TakesCornersOfOnePlaceForOneVertex) {
  const Shape torus = test::torus(20, 30);
  const RightTriangleLayout whole = lay_out(torus);
  const RightTriangleLayout soup = lay_out(test::soup_of(torus));
  EXPECT_EQ(soup.interior_edges, whole.interior_edges);
  EXPECT_EQ(soup.continuous_edges, whole.continuous_edges);
}

// In no order at all the same mesh is found less well, since late patches begin anywhere.
TEST(RightTriangleLayout, FindsMostOfATorusInAnyOrderOfItsTriangles) {
  Shape soup = test::soup_of(test::torus(64, 128));
  test::shuffle(soup, 1);
  const RightTriangleLayout layout = lay_out(soup);
  expect_sound(soup, layout);
  EXPECT_EQ(layout.lone_triangles, 0u);
  EXPECT_GT(share(layout), 0.95);
}

// Petersen: the dual graph of a closed mesh has a perfect matching. Diagonals alone are a third of the edges.
TEST(RightTriangleLayout, LeavesNoTriangleOfAClosedMeshAlone) {
  for (int steps = 0; steps <= 5; ++steps) {
    Shape sphere = test::icosphere(steps);
    if (steps > 2) test::shuffle(sphere, 7);
    const RightTriangleLayout layout = lay_out(sphere);
    EXPECT_EQ(layout.lone_triangles, 0u) << steps;
    EXPECT_GE(share(layout), 1.0 / 3) << steps;
  }
}

// The most pairs there can be among at most 16 triangles, by trying all of them.
std::size_t most_pairs(const std::vector<unsigned>& neighbours, unsigned left) {
  if (left == 0) return 0;
  const auto t = static_cast<unsigned>(std::countr_zero(left));
  const unsigned rest = left & (left - 1);
  std::size_t most = most_pairs(neighbours, rest);
  for (unsigned other = neighbours[t] & rest; other != 0; other &= other - 1) {
    const unsigned bit = other & (~other + 1);
    most = std::max(most, 1 + most_pairs(neighbours, rest & ~bit));
  }
  return most;
}

TEST(RightTriangleLayout, LeavesAsFewTrianglesAloneAsAnyPairingCould) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 300; ++round) {
    // Some of the triangles of a larger mesh: a border everywhere, islands, odd cycles about vertices.
    Shape shape = round % 2 == 0 ? test::icosphere(1) : test::plane(4, 4);
    test::shuffle(shape, random());
    shape.triangles.resize(3 + random() % 14);
    std::vector<unsigned> neighbours(shape.triangles.size(), 0);
    for (std::size_t s = 0; s < shape.triangles.size(); ++s) {
      for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        std::size_t shared = 0;
        for (const std::uint32_t a : shape.triangles[s])
          shared +=
              static_cast<std::size_t>(std::count(shape.triangles[t].begin(), shape.triangles[t].end(), a));
        if (s != t && shared == 2) neighbours[s] |= 1u << t;
      }
    }
    const unsigned all = (1u << shape.triangles.size()) - 1;
    const RightTriangleLayout layout = lay_out(shape);
    expect_sound(shape, layout);
    EXPECT_EQ(layout.lone_triangles, shape.triangles.size() - 2 * most_pairs(neighbours, all)) << round;
  }
}

TEST(RightTriangleLayout, GivesLoneTrianglesHalfACellEach) {
  Shape shape;
  for (int i = 0; i < 7; ++i) {
    const auto first = static_cast<std::uint32_t>(shape.positions.size());
    const float x = 2.0f * static_cast<float>(i);
    shape.positions.insert(shape.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    shape.triangles.push_back({first, first + 1, first + 2});
  }
  const RightTriangleLayout layout = lay_out(shape);
  expect_sound(shape, layout);
  EXPECT_EQ(layout.lone_triangles, 7u);
  EXPECT_EQ(layout.columns * layout.rows, 4u);
  // The right angle is the triangle's own.
  for (const HalfCell& half : layout.halves) EXPECT_EQ(half.b, 0);
}

// A strip of an odd number of triangles: the one left over lies beside its neighbour where there is room.
TEST(RightTriangleLayout, PutsALoneTriangleBesideItsNeighbour) {
  Shape strip = test::plane(3, 1);
  strip.triangles.pop_back();
  const RightTriangleLayout layout = lay_out(strip);
  expect_sound(strip, layout);
  EXPECT_EQ(layout.lone_triangles, 1u);
  EXPECT_EQ(layout.interior_edges, 4u);
  EXPECT_GE(layout.continuous_edges, 3u);
}

TEST(RightTriangleLayout, TakesWhatIsNoSurface) {
  Shape shape;
  shape.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  // Three triangles at one edge, one turned over, one the same again, one without area, one without corners.
  shape.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 0, 2}, {0, 1, 2}, {0, 0, 1}, {3, 3, 3}};
  const RightTriangleLayout layout = lay_out(shape);
  expect_sound(shape, layout);
  expect_sound({}, lay_out({}));
  EXPECT_EQ(lay_out({}).columns, 1u);
}

TEST(RightTriangleLayout, IsTheSameEveryTime) {
  Shape sphere = test::icosphere(4);
  test::shuffle(sphere, 3);
  const RightTriangleLayout one = lay_out(sphere);
  const RightTriangleLayout two = lay_out(sphere);
  for (std::size_t t = 0; t < one.halves.size(); ++t) ASSERT_EQ(one.texcoords(t), two.texcoords(t));
}

// Size and place of the mesh do not matter: powers of two change no bit of a ratio.
TEST(RightTriangleLayout, DoesNotDependOnTheUnit) {
  const Shape sphere = test::icosphere(3);
  const RightTriangleLayout one = lay_out(sphere);
  for (const float scale : {0x1p-40f, 0x1p60f}) {
    Shape scaled = sphere;
    for (glm::vec3& p : scaled.positions) p *= scale;
    const RightTriangleLayout other = lay_out(scaled);
    for (std::size_t t = 0; t < one.halves.size(); ++t) ASSERT_EQ(one.texcoords(t), other.texcoords(t));
  }
}

}  // namespace
}  // namespace sweepkit::texmap
