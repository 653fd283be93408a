// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "triangulate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace sweepkit::sweep {
namespace {

// Covers the polygon once: the right count, every vertex, no negative or zero area, and the areas sum to the
// whole.
void expect_covers(const std::vector<glm::dvec2>& polygon) {
  const std::vector<Triangle> triangles = triangulate_polygon(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0;
  std::set<std::uint32_t> used;
  for (const Triangle& t : triangles) {
    const std::vector<glm::dvec2> corners = {polygon[t[0]], polygon[t[1]], polygon[t[2]]};
    const double area = twice_signed_area(corners);
    EXPECT_GT(area, 0);
    sum += area;
    used.insert(t.begin(), t.end());
  }
  EXPECT_EQ(used.size(), polygon.size());
  const double whole = twice_signed_area(polygon);
  EXPECT_NEAR(sum, whole, 1e-9 * whole);
}

TEST(Triangulate, CoversConvexOutlinesOfEverySize) {
  for (int n = 3; n < 200; ++n) {
    std::vector<glm::dvec2> circle;
    for (int i = 0; i < n; ++i)
      circle.push_back({std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n)});
    expect_covers(circle);
  }
}

TEST(Triangulate, CoversASquareWithManyPointsOnItsSides) {
  std::vector<glm::dvec2> square;
  for (int i = 0; i < 10; ++i) square.push_back({i / 10.0, 0});
  for (int i = 0; i < 10; ++i) square.push_back({1, i / 10.0});
  for (int i = 0; i < 10; ++i) square.push_back({1 - i / 10.0, 1});
  for (int i = 0; i < 10; ++i) square.push_back({0, 1 - i / 10.0});
  expect_covers(square);
}

TEST(Triangulate, CoversStarsAndCombs) {
  std::vector<glm::dvec2> star;
  for (int i = 0; i < 40; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.3;
    star.push_back(
        {r * std::cos(2 * std::numbers::pi * i / 40), r * std::sin(2 * std::numbers::pi * i / 40)});
  }
  expect_covers(star);
  std::vector<glm::dvec2> comb = {{0, 0}, {20, 0}};
  for (int i = 20; i > 0; --i) {
    comb.push_back({i - 0.2, 5});
    comb.push_back({i - 0.8, 1});
  }
  expect_covers(comb);
}

TEST(Triangulate, CoversRandomStarShapedOutlines) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.05, 1);
  for (int round = 0; round < 200; ++round) {
    std::vector<glm::dvec2> outline;
    const int n = 5 + round % 60;
    for (int i = 0; i < n; ++i) {
      const double r = radius(random);
      outline.push_back(
          {r * std::cos(2 * std::numbers::pi * i / n), r * std::sin(2 * std::numbers::pi * i / n)});
    }
    expect_covers(outline);
  }
}

TEST(Triangulate, CoversATurnedSquareWhosePointsAreOffItsSidesByRounding) {
  for (int turn = 1; turn < 40; ++turn) {
    const double c = std::cos(0.1 * turn);
    const double s = std::sin(0.1 * turn);
    std::vector<glm::dvec2> square;
    const auto add = [&](double x, double y) { square.push_back({c * x - s * y, s * x + c * y}); };
    for (int i = 0; i < 7; ++i) add(i / 7.0, 0);
    for (int i = 0; i < 7; ++i) add(1, i / 7.0);
    for (int i = 0; i < 7; ++i) add(1 - i / 7.0, 1);
    for (int i = 0; i < 7; ++i) add(0, 1 - i / 7.0);
    expect_covers(square);
    // Each at least a thousandth of the cell's area: none that float32 would flatten.
    for (const Triangle& t : triangulate_polygon(square)) {
      EXPECT_GT(twice_signed_area(std::vector<glm::dvec2>{square[t[0]], square[t[1]], square[t[2]]}),
                1e-3 / 49);
    }
  }
}

TEST(Triangulate, CoversASpiralOfTwoArms) {
  // Two walls 0.1 apart wound three times about each other: long, thin and concave everywhere.
  std::vector<glm::dvec2> spiral;
  const int n = 300;
  for (int i = 0; i <= n; ++i) {
    const double angle = 6 * std::numbers::pi * i / n;
    spiral.push_back({(1 + 0.1 * angle) * std::cos(angle), (1 + 0.1 * angle) * std::sin(angle)});
  }
  for (int i = n; i >= 0; --i) {
    const double angle = 6 * std::numbers::pi * i / n;
    spiral.push_back({(0.9 + 0.1 * angle) * std::cos(angle), (0.9 + 0.1 * angle) * std::sin(angle)});
  }
  if (twice_signed_area(spiral) < 0) std::reverse(spiral.begin(), spiral.end());
  expect_covers(spiral);
}

TEST(Triangulate, CoversAnOutlineOfAsManyCellsAsThereMayBe) {
  // A search of every vertex for every ear would take minutes here.
  std::vector<glm::dvec2> flower;
  const int n = 32768;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double r = 1 + 0.4 * std::cos(9 * angle);
    flower.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  const std::vector<Triangle> triangles = triangulate_polygon(flower);
  ASSERT_EQ(triangles.size(), flower.size() - 2);
  double sum = 0;
  for (const Triangle& t : triangles)
    sum += twice_signed_area(std::vector<glm::dvec2>{flower[t[0]], flower[t[1]], flower[t[2]]});
  EXPECT_NEAR(sum, twice_signed_area(flower), 1e-9);
}

TEST(Triangulate, OfAnOutlineThatCrossesItselfStillUsesEveryVertexAndEnds) {
  const std::vector<glm::dvec2> bow = {{0, 0}, {2, 2}, {2, 0}, {0, 2}, {-1, 1}};
  std::set<std::uint32_t> used;
  const std::vector<Triangle> triangles = triangulate_polygon(bow);
  for (const Triangle& t : triangles) used.insert(t.begin(), t.end());
  EXPECT_EQ(triangles.size(), 3u);
  EXPECT_EQ(used.size(), 5u);
}

// Covers a polygon with holes once.
void expect_covers_region(const std::vector<std::vector<glm::dvec2>>& outlines) {
  std::vector<glm::dvec2> points;
  double whole = 0;
  for (const auto& outline : outlines) {
    points.insert(points.end(), outline.begin(), outline.end());
    whole += twice_signed_area(outline);  // a hole's is negative
  }
  const std::vector<Triangle> triangles = triangulate_region(outlines);
  EXPECT_EQ(triangles.size(), points.size() + 2 * (outlines.size() - 1) - 2);
  double sum = 0;
  std::set<std::uint32_t> used;
  for (const Triangle& t : triangles) {
    const double area = twice_signed_area(std::vector<glm::dvec2>{points[t[0]], points[t[1]], points[t[2]]});
    EXPECT_GT(area, 0);
    sum += area;
    used.insert(t.begin(), t.end());
  }
  EXPECT_EQ(used.size(), points.size());
  EXPECT_NEAR(sum, whole, 1e-9 * whole);
}

std::vector<glm::dvec2> hole(glm::dvec2 center, double radius, int n) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < n; ++i) {
    const double a = -2 * std::numbers::pi * i / n;
    points.push_back(center + radius * glm::dvec2(std::cos(a), std::sin(a)));
  }
  return points;
}

TEST(Triangulate, CoversAGridOfHolesWhoseVerticesLieInRows) {
  std::vector<std::vector<glm::dvec2>> outlines = {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) outlines.push_back(hole({2 * x + 1, 2 * y + 1}, 0.6, 4 + (x + y) % 9));
  }
  expect_covers_region(outlines);
}

TEST(Triangulate, CoversRandomHolesInARandomOutline) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 60; ++round) {
    std::vector<glm::dvec2> outer;
    const int n = 5 + round;
    for (int i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n;
      outer.push_back((2 + unit(random)) * glm::dvec2(std::cos(a), std::sin(a)));
    }
    std::vector<std::vector<glm::dvec2>> outlines = {outer};
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        const glm::dvec2 center(0.5 * x + 0.1 * unit(random), 0.5 * y + 0.1 * unit(random));
        // Well inside of the chords between neighbours.
        if (glm::length(center) < 2 * std::cos(std::numbers::pi / n) - 0.3 && unit(random) < 0.7) {
          outlines.push_back(
              hole(center, 0.05 + 0.14 * unit(random), 3 + static_cast<int>(9 * unit(random))));
        }
      }
    }
    expect_covers_region(outlines);
  }
}

TEST(Triangulate, CoversAHoleInANarrowCombsBack) {
  // Every tooth hides the outline to the right of the holes behind it.
  std::vector<glm::dvec2> comb = {{0, 0}, {1, 0}};
  for (int i = 0; i < 10; ++i) {
    comb.emplace_back(5, i);
    comb.emplace_back(1, i + 0.5);
  }
  comb.emplace_back(1, 11);
  comb.emplace_back(0, 11);
  std::vector<std::vector<glm::dvec2>> outlines = {comb};
  for (int i = 1; i < 10; ++i) outlines.push_back(hole({0.5, i + 0.3}, 0.2, 7));
  expect_covers_region(outlines);
}

}  // namespace
}  // namespace sweepkit::sweep
