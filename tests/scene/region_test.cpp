// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "outline_measures.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "winding.hpp"

namespace sweepkit::scene {
namespace {

using sweep::Curve2;

Curve2 circle(const glm::dvec2& center, double radius, bool is_counter_clockwise = true) {
  const double turn = is_counter_clockwise ? 360 : -360;
  return Curve2({sweep::ArcSegment<2>{center, {radius, 0}, {0, radius}, 0, turn}});
}

Curve2 square(const glm::dvec2& low, double side, bool is_counter_clockwise = true) {
  std::vector<glm::dvec2> points = {low, low + glm::dvec2(side, 0), low + side, low + glm::dvec2(0, side)};
  if (!is_counter_clockwise) std::swap(points[1], points[3]);
  return sweep::polyline<2>(points, true);
}

std::vector<double> areas(const std::vector<Curve2>& outlines) {
  std::vector<double> areas;
  areas.reserve(outlines.size());
  for (const Curve2& outline : outlines) areas.push_back(area(outline));
  return areas;
}

std::vector<double> bounded(const std::vector<FilledShape>& shapes) {
  return areas(bounding_outlines(shapes));
}

void expect_areas(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  // Sums of some dozen products below 100.
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
}

TEST(Region, AnOutlineHasItsInsideOnItsLeftHoweverItIsDrawn) {
  expect_areas(bounded({{FillRule::kNonzero, {square({0, 0}, 2, true)}}}), {4});
  expect_areas(bounded({{FillRule::kNonzero, {square({0, 0}, 2, false)}}}), {4});
  expect_areas(bounded({{FillRule::kEvenOdd, {square({0, 0}, 2, false)}}}), {4});
}

TEST(Region, AHoleByNonzeroIsDrawnTheOtherWay) {
  const Curve2 outer = square({0, 0}, 4);
  expect_areas(bounded({{FillRule::kNonzero, {outer, square({1, 1}, 2, false)}}}), {16, -4});
  expect_areas(bounded({{FillRule::kNonzero, {outer, square({1, 1}, 2, true)}}}), {16});
}

TEST(Region, AHoleByEvenOddIsEverySecondOutlineInwards) {
  for (const bool is_ccw : {true, false}) {
    std::vector<Curve2> outlines;
    for (int side = 1; side <= 5; ++side) outlines.push_back(square(glm::dvec2(-0.5 * side), side, is_ccw));
    expect_areas(bounded({{FillRule::kEvenOdd, outlines}}), {1, -4, 9, -16, 25});
  }
}

TEST(Region, TheRulesDifferWhereAnOutlineWindsTwice) {
  // Two turns about the middle: nonzero fills it, evenodd does not. It bounds the region either way.
  std::vector<glm::dvec2> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * std::numbers::pi * 2 * i / 5;
    star.emplace_back(std::cos(angle), std::sin(angle));
  }
  const Curve2 pentagram = sweep::polyline<2>(star, true);
  const Curve2 dot = circle({0, 0}, 0.1, true);
  const Curve2 hole = circle({0, 0}, 0.1, false);
  EXPECT_EQ(bounding_outlines(std::vector<FilledShape>{{FillRule::kNonzero, {pentagram, dot}}}).size(), 1);
  EXPECT_EQ(bounding_outlines(std::vector<FilledShape>{{FillRule::kEvenOdd, {pentagram, dot}}}).size(), 2);
  // 2 - 1 turns are still a filled middle.
  EXPECT_EQ(bounding_outlines(std::vector<FilledShape>{{FillRule::kNonzero, {pentagram, hole}}}).size(), 1);
}

TEST(Region, WhatLiesUnderAnotherShapeBoundsNothing) {
  const FilledShape plate{FillRule::kNonzero, {square({0, 0}, 4)}};
  const FilledShape under{FillRule::kNonzero, {square({1, 1}, 1, false)}};
  expect_areas(bounded({plate, under}), {16});
  expect_areas(bounded({under, plate}), {16});
  // A hole of one shape that another fills is none.
  const FilledShape frame{FillRule::kNonzero, {square({0, 0}, 4), square({1, 1}, 2, false)}};
  expect_areas(bounded({frame, {FillRule::kNonzero, {square({0.5, 0.5}, 3)}}}), {16});
}

TEST(Region, EqualOutlinesCountOnce) {
  const Curve2 outline = circle({3, 4}, 2);
  EXPECT_EQ(bounding_outlines(
                std::vector<FilledShape>{{FillRule::kNonzero, {outline}}, {FillRule::kNonzero, {outline}}})
                .size(),
            1);
}

TEST(Region, AnOutlineOfNoAreaIsLeftOut) {
  const Curve2 there_and_back = sweep::polyline<2>({{0, 0}, {1, 1}, {2, 2}}, true);
  EXPECT_TRUE(bounding_outlines(std::vector<FilledShape>{{FillRule::kNonzero, {there_and_back}}}).empty());
  EXPECT_TRUE(bounding_outlines({}).empty());
}

TEST(Region, OutlinesThatCrossOrTouchAreKeptWhole) {
  expect_areas(bounded({{FillRule::kNonzero, {square({0, 0}, 2), square({1, 1}, 2)}}}), {4, 4});
  // Side by side, with a whole side in common.
  expect_areas(bounded({{FillRule::kNonzero, {square({0, 0}, 2), square({2, 0}, 2)}}}), {4, 4});
}

TEST(Region, CurvesStayAsTheyAreExceptForTheirDirection) {
  const Curve2 outer = circle({1, 2}, 3);
  const Curve2 inner = circle({1, 2}, 1);
  const auto outlines = bounding_outlines(std::vector<FilledShape>{{FillRule::kEvenOdd, {outer, inner}}});
  ASSERT_EQ(outlines.size(), 2);
  for (int i = 0; i <= 8; ++i) {
    const double t = i / 8.0;
    EXPECT_EQ(outlines[0].evaluate({0, t}).position, outer.evaluate({0, t}).position);
    EXPECT_EQ(outlines[1].evaluate({0, t}).position, inner.evaluate({0, 1 - t}).position);
  }
}

TEST(Region, ReversalKeepsEveryPointOfEveryKindOfSegment) {
  const Curve2 mixed({sweep::BezierSegment<2>{{{1, 0}, {2, 1}, {2, 3}, {0, 2}}},
                      sweep::ArcSegment<2>{{0, 0}, {0, 2}, {-1, 0}, 0, 270, {1, 0}}});
  const Outline turned = reversed(mixed);
  ASSERT_EQ(turned.segments.size(), 2);
  for (int i = 0; i <= 16; ++i) {
    const double t = i / 16.0;
    for (std::size_t k = 0; k < 2; ++k) {
      const glm::dvec2 back = sweep::evaluate<2>(turned.segments[1 - k], 1 - t).position;
      // Coordinates of 2 and a handful of sums.
      EXPECT_NEAR(glm::distance(back, mixed.evaluate({k, t}).position), 0, 4e-15);
    }
  }
}

TEST(Region, ThinWallsFarFromTheOriginKeepTheirSides) {
  const glm::dvec2 far(1e7, -1e7);
  const auto outlines = bounding_outlines(
      std::vector<FilledShape>{{FillRule::kEvenOdd, {circle(far, 1), circle(far, 0.9999)}}});
  ASSERT_EQ(outlines.size(), 2);
  // Coordinates of 1e7 round by 1e-9, times the 6 m round the circle.
  EXPECT_NEAR(area(outlines[0]), std::numbers::pi, 1e-8 * 1e7 * 1e-6);
  EXPECT_LT(area(outlines[1]), 0);
}

// The depth of each circle among circles that do not cross says what bounds: by evenodd all of them, outwards
// for an even depth; by nonzero those where the sum of turns becomes or ceases to be 0.
TEST(Region, AgreesWithTheDepthOfNestedCircles) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < 50; ++round) {
    struct Ring {
      glm::dvec2 center;
      double radius;
      int sign;
    };
    std::vector<Ring> rings;
    for (int tries = 0; tries < 300; ++tries) {
      const Ring ring{{share(random) * 10, share(random) * 10},
                      0.05 + share(random) * 4 * share(random),
                      share(random) < 0.5 ? -1 : 1};
      bool is_apart = true;
      for (const Ring& other : rings) {
        const double distance = glm::distance(ring.center, other.center);
        // Flattened circles stay within 1.2e-3 of the radius.
        const bool crosses =
            distance < 1.01 * (ring.radius + other.radius) &&
            distance > std::abs(ring.radius - other.radius) - 0.01 * (ring.radius + other.radius);
        is_apart = is_apart && !crosses;
      }
      if (is_apart) rings.push_back(ring);
    }
    FilledShape shape;
    for (const Ring& ring : rings) shape.outlines.push_back(circle(ring.center, ring.radius, ring.sign > 0));
    for (const FillRule rule : {FillRule::kNonzero, FillRule::kEvenOdd}) {
      shape.rule = rule;
      std::vector<double> expected;
      for (const Ring& ring : rings) {
        int outside = 0;
        for (const Ring& other : rings) {
          const bool holds =
              glm::distance(ring.center, other.center) < other.radius && other.radius > ring.radius;
          if (holds) outside += other.sign;
        }
        const auto is_filled = [&](int turns) {
          return rule == FillRule::kNonzero ? turns != 0 : turns % 2 != 0;
        };
        const bool is_in = is_filled(outside + ring.sign);
        if (is_in == is_filled(outside)) continue;
        expected.push_back((is_in ? 1 : -1) * std::numbers::pi * ring.radius * ring.radius);
      }
      SCOPED_TRACE("round " + std::to_string(round));
      expect_areas(bounded({shape}), expected);
    }
  }
}

TEST(Region, TooMuchToDecideIsRefusedInBoundedTime) {
  // Combs whose teeth all reach over the whole height: every question looks at every tooth.
  std::vector<FilledShape> shapes;
  for (int k = 0; k < 100; ++k) {
    std::vector<glm::dvec2> comb = {{0.001 * k, -1}};
    for (int i = 0; i < 4000; ++i) comb.emplace_back(0.001 * k + i, i % 2 == 0 ? 1000 : 0);
    comb.emplace_back(0.001 * k + 4000, -1);
    for (int copy = 0; copy < 4; ++copy)
      shapes.push_back({FillRule::kNonzero, {sweep::polyline<2>(comb, true)}});
  }
  EXPECT_EQ(
      refusal([&] { bounding_outlines(shapes); }),
      "has too many outlines one over another to tell inside from outside; choose an element by \"id\", "
      "or simplify the drawing");
}

// The sum of the angles that the edges subtend, in turns: slow, and right away from the edges.
double turns_by_angles(const std::vector<Edge>& edges, const glm::dvec2& point) {
  double angle = 0;
  for (const Edge& edge : edges) {
    const glm::dvec2 a = edge.from - point;
    const glm::dvec2 b = edge.to - point;
    angle += std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
  }
  return angle / (2 * std::numbers::pi);
}

TEST(Winding, AgreesWithTheSumOfAnglesRoundEveryPoint) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> spread;
  for (const int count : {3, 10, 100}) {
    std::vector<glm::dvec2> corners;
    for (int i = 0; i < count; ++i) corners.emplace_back(spread(random), spread(random));
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      edges.push_back({corners[i], corners[(i + 1) % corners.size()], 0});
    }
    const Winding winding(edges);
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec2 point(spread(random), spread(random));
      std::vector<int> turns = {0};
      winding.count(point, turns);
      EXPECT_NEAR(turns[0], turns_by_angles(edges, point), 1e-9);
    }
  }
}

TEST(Winding, CountsAVertexAtThePointsHeightOnce) {
  const std::vector<glm::dvec2> diamond = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < 4; ++i) edges.push_back({diamond[i], diamond[(i + 1) % 4], 0});
  const Winding winding(edges);
  for (const auto& [x, expected] :
       {std::pair(-2.0, 0), std::pair(-0.5, 1), std::pair(0.5, 1), std::pair(2.0, 0)}) {
    std::vector<int> turns = {0};
    winding.count({x, 0}, turns);
    EXPECT_EQ(turns[0], expected) << x;
  }
}

TEST(Winding, LooksAtAFewEdgesOfMany) {
  std::vector<Edge> edges;
  constexpr int kCount = 100'000;
  const auto on_circle = [](int i) {
    const double angle = 2 * std::numbers::pi * (i % kCount) / kCount;
    return glm::dvec2(std::cos(angle), std::sin(angle));
  };
  for (int i = 0; i < kCount; ++i) edges.push_back({on_circle(i), on_circle(i + 1), 0});
  const Winding winding(edges);
  std::vector<int> turns = {0};
  // Half as many strips as edges hold four each, twice so many where edges lie steep or a strip's border.
  EXPECT_LT(winding.count({0.3, 0.2}, turns), 20);
  EXPECT_EQ(turns[0], 1);
}

}  // namespace
}  // namespace sweepkit::scene
