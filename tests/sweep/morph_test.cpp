// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "matching.hpp"
#include "mesh_measures.hpp"
#include "outline_sampler.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep {
namespace {

using test::measure;
using test::Measures;

constexpr double kPi = std::numbers::pi;

Curve3 straight(double length) {
  return polyline<3>({{0, 0, 0}, {0, 0, length}}, false);
}

Curve2 turned(const Curve2& polygon, double turn_deg) {
  const double a = turn_deg * kPi / 180;
  std::vector<glm::dvec2> corners;
  for (const Segment<2>& segment : polygon.segments()) {
    const glm::dvec2 p = evaluate<2>(segment, 0).position;
    corners.emplace_back(std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y);
  }
  return polyline<2>(corners, true);
}

void expect_sound(const Mesh& mesh, long euler = 2) {
  const Measures m = measure(mesh);
  EXPECT_EQ(m.open_edges, 0u);
  EXPECT_EQ(m.euler, euler);
  EXPECT_GT(m.volume, 0);
  EXPECT_GT(m.smallest_triangle, 0);
  EXPECT_LT(m.worst_normal_length, 1e-6);
}

RisingMap matched(const Curve2& from, const Curve2& to) {
  return match(Walk(from, false), Walk(to, false));
}

TEST(Matching, OfAContourWithItselfIsTheIdentity) {
  for (const Curve2& contour :
       {circle_contour(1), star_contour(5, 1, 0.4), rectangle_contour(2, 1, 0.2), polygon_contour(3, 1)}) {
    const RisingMap map = matched(contour, contour);
    for (double x = 0; x <= 1; x += 0.05) EXPECT_NEAR(map.at(x), x, 1e-9);
  }
}

TEST(Matching, BringsCornersToCornersAtAnyTurn) {
  const Curve2 square = polygon_contour(4, 1);
  for (const double turn : {10.0, 44.0, 80.0, 95.0, 271.0}) {
    const Curve2 other = turned(square, turn);
    const RisingMap map = matched(square, other);
    // A quarter of the length apart; the nearest turn of the square onto itself.
    const double start = map.at(0) - std::floor(map.at(0));
    const double nearest = std::fmod(1 - std::round(turn / 90) / 4 + 1, 1.0);
    EXPECT_NEAR(std::remainder(start - nearest, 1.0), 0, 1e-9) << turn;
    EXPECT_NEAR(map.at(0.25) - map.at(0), 0.25, 1e-9);
  }
}

TEST(Matching, KeepsTheOrderAndGoesOnceRound) {
  const Curve2 star = star_contour(7, 1, 0.3);
  for (const Curve2& other :
       {circle_contour(2), polygon_contour(3, 1), polygon_contour(90, 1), rectangle_contour(5, 0.2)}) {
    const RisingMap map = matched(star, other);
    EXPECT_EQ(map.knots.front().x, 0);
    EXPECT_EQ(map.knots.back().x, 1);
    EXPECT_NEAR(map.knots.back().y - map.knots.front().y, 1, 1e-12);
    for (std::size_t i = 1; i < map.knots.size(); ++i) {
      EXPECT_GT(map.knots[i].x, map.knots[i - 1].x);
      EXPECT_GT(map.knots[i].y, map.knots[i - 1].y);
      EXPECT_NEAR(map.inverse(map.knots[i].y), map.knots[i].x, 1e-9);
    }
  }
}

TEST(Morph, BetweenCirclesIsAConesFrustum) {
  const Mesh mesh =
      sweep(circle_contour(2), straight(3), {.tessellation = {256, 16}, .morph = {{1, {circle_contour(1)}}}});
  expect_sound(mesh);
  const double inscribed = 1 - std::pow(2 * kPi / 256, 2) / 6;
  EXPECT_NEAR(measure(mesh).volume, inscribed * kPi * 3 / 3 * (4 + 2 + 1), 1e-3);
  // Its slope is 1 in 3.
  for (std::uint32_t i = 0; i < mesh.patches.front().vertex_count(); ++i) {
    EXPECT_NEAR(mesh.normals()[i].z, 1 / std::sqrt(10), 1e-6);
  }
}

TEST(Morph, FromSquareToTurnedSquareHasThePrismatoidsVolume) {
  // Ruled between sections that change linearly, the area is a quadratic in t, so Simpson's rule is exact.
  const Curve2 a = rectangle_contour(2, 1);
  const Curve2 b = rectangle_contour(1, 3);
  const Mesh mesh = sweep(a, straight(2), {.tessellation = {64, 64}, .morph = {{1, {b}}}});
  expect_sound(mesh);
  // Side by side w = 2 - t, h = 1 + 2 t: the integral of (2 - t)(1 + 2t) from 0 to 1 is 2 + 3/2 - 2/3.
  EXPECT_NEAR(measure(mesh).volume, 2 * (2 + 1.5 - 2.0 / 3), 1e-3);
}

TEST(Morph, KeepsEveryCornerOfEveryKeyAsAVertex) {
  const Curve2 star = star_contour(5, 1, 0.4);
  const Curve2 square = rectangle_contour(1.2, 1.2);
  const Mesh mesh = sweep(star, straight(1),
                          {.tessellation = {16, 8}, .morph = {{0.5, {circle_contour(0.8)}}, {1, {square}}}});
  expect_sound(mesh);
  const auto has = [&](const glm::dvec3& wanted) {
    for (std::uint32_t i = 0; i < mesh.n_vertices(); ++i) {
      if (glm::length(test::position(mesh, i) - wanted) < 1e-6) return true;
    }
    return false;
  };
  // x of the contour lies on N = +X for a trajectory along +Z with B up.
  for (const Segment<2>& segment : star.segments()) {
    const glm::dvec2 p = evaluate<2>(segment, 0).position;
    EXPECT_TRUE(has({p.x, p.y, 0})) << p.x << ' ' << p.y;
  }
  for (const double x : {-0.6, 0.6}) {
    for (const double y : {-0.6, 0.6}) EXPECT_TRUE(has({x, y, 1}));
  }
}

TEST(Morph, PassesThroughItsKeysAndDoesNotOvershootBesideAKeyAtRest) {
  const std::vector<MorphKey> keys = {
      {0.45, {circle_contour(1)}}, {0.55, {circle_contour(2)}}, {1, {circle_contour(2)}}};
  const Mesh mesh = sweep(circle_contour(1), straight(1), {.tessellation = {32, 200}, .morph = keys});
  expect_sound(mesh);
  for (std::uint32_t i = 0; i < mesh.patches.front().vertex_count(); ++i) {
    const glm::dvec3 p = test::position(mesh, i);
    const double r = std::hypot(p.x, p.y);
    EXPECT_GE(r, 1 - 1e-6);
    EXPECT_LE(r, 2 + 1e-6);
    if (p.z < 0.45 || p.z > 0.55) {
      EXPECT_NEAR(r, p.z < 0.5 ? 1 : 2, 1e-6);
    }
  }
}

TEST(Morph, NormalsAgreeWithFiniteDifferences) {
  const std::vector<MorphKey> keys = {{0.3, {ellipse_contour(0.45, 0.2)}},
                                      {0.7, {star_contour(6, 0.4, 0.3)}},
                                      {1, {rectangle_contour(0.3, 0.6, 0.1)}}};
  const Curve3 bow = bezier_curve<3>({{0, 0, 0}, {1, 3, 0}, {3, 4, 2}, {5, 3, 6}});
  const Law law = Law::through({{0, 1}, {0.5, 1.3}, {1, 0.6}});
  // Cells so small that a triangle's own normal differs from the surface's by less than 1e-2.
  const Mesh mesh = sweep(
      circle_contour(0.3), bow,
      {.tessellation = {600, 600}, .crease_deg = 1, .profile = {law, law}, .morph = keys, .twist_deg = 40});
  expect_sound(mesh);
  EXPECT_GT(measure(mesh).worst_normal_cosine, 0.999);
}

TEST(Morph, OfStarsAndCirclesDoesNotCrossItself) {
  for (const int points : {3, 5, 9}) {
    const Mesh mesh = sweep(star_contour(points, 1, 0.3), straight(1),
                            {.tessellation = {120, 9}, .morph = {{1, {turned(polygon_contour(4, 1), 30)}}}});
    expect_sound(mesh);
    // Every ring runs counter-clockwise and its area lies between those of the ends.
    const GridPatch& patch = mesh.patches.front();
    EXPECT_GT(patch.rows, 0u);
    double least = 1e9;
    for (std::uint32_t j = 0; j <= 9; ++j) {
      double area = 0;
      for (const GridPatch& p : mesh.patches) {
        for (std::uint32_t i = 0; i < p.columns; ++i) {
          const glm::dvec3 a = test::position(mesh, p.vertex(i, j));
          const glm::dvec3 b = test::position(mesh, p.vertex(i + 1, j));
          area += 0.5 * (a.x * b.y - a.y * b.x);
        }
      }
      least = std::min(least, area);
    }
    EXPECT_GT(least, 0.3 * std::sin(kPi / points) * points * 0.99);
  }
}

TEST(Morph, OnAClosedTrajectoryComesHomeToItsContour) {
  const SweepOptions options{.tessellation = {32, 64},
                             .morph = {{0.5, {star_contour(5, 0.4, 0.2)}}, {1, {circle_contour(0.3)}}}};
  expect_sound(sweep(circle_contour(0.3), circle_trajectory(2), options), 0);
  try {
    sweep(circle_contour(0.3), circle_trajectory(2), {.morph = {{0.5, {circle_contour(0.4)}}}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(
        error.problem(),
        "morph ends in another contour than it began with, but the trajectory is closed; end it with the "
        "contour itself at t = 1");
  }
}

TEST(Morph, OfOpenContoursGoesFromEndToEnd) {
  const Curve2 flat = polyline<2>({{-1, 0}, {1, 0}}, false);
  const Curve2 roof = polyline<2>({{-1, 0}, {0, 1}, {1, 0}}, false);
  const Mesh mesh = sweep(flat, straight(1), {.tessellation = {2, 4}, .morph = {{1, {roof}}}});
  EXPECT_EQ(mesh.areas.size(), 1u);
  EXPECT_EQ(measure(mesh).euler, 1);
}

TEST(Morph, SaysWhatItRefuses) {
  const auto problem = [](const std::vector<Curve2>& contour, const std::vector<MorphKey>& morph) {
    try {
      sweep(contour, straight(1), {.morph = morph});
    } catch (const InputError& error) {
      return error.problem();
    }
    return std::string("nothing");
  };
  const Curve2 circle = circle_contour(1);
  const Curve2 small = circle_contour(0.5);
  EXPECT_EQ(
      problem({circle}, {{0, {small}}}),
      "morph goes on at t = 0 after t = 0; let its t ascend, above 0 (where the contour itself is) and at "
      "most 1");
  EXPECT_EQ(
      problem({circle}, {{0.5, {small}}, {0.4, {circle}}}),
      "morph goes on at t = 0.4 after t = 0.5; let its t ascend, above 0 (where the contour itself is) and "
      "at most 1");
  EXPECT_EQ(problem({circle}, {{1, {polyline<2>({{0, 0}, {1, 1}}, false)}}}),
            "morph at t = 1 goes from a closed contour to an open one; let all be closed or all open");
  EXPECT_EQ(
      problem({circle}, {{1, {circle, small}}}),
      "morph at t = 1 has 2 outlines, 1 of them holes, but the contour has 1 and 0; let every contour have "
      "as many");
}

TEST(Holes, MakeATubeOfTheRingsVolumeAndGenus) {
  const std::vector<Curve2> ring = {circle_contour(1), circle_contour(0.5)};
  const Mesh mesh = sweep(ring, straight(2), {.tessellation = {192, 4}});
  expect_sound(mesh, 0);  // a torus
  EXPECT_EQ(mesh.areas.size(), 4u) << "two walls, two caps";
  EXPECT_NEAR(measure(mesh).volume, kPi * 0.75 * 2, 2e-3);
}

TEST(Holes, MayBeDrawnEitherWayAndInAnyOrder) {
  const Curve2 outer = rectangle_contour(4, 4);
  const Curve2 clockwise = polyline<2>({{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}, true);
  const Curve2 counter = polyline<2>({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, true);
  for (const std::vector<Curve2>& contour :
       {std::vector{outer, clockwise}, std::vector{outer, counter}, std::vector{counter, outer}}) {
    const Mesh mesh = sweep(contour, straight(1), {.tessellation = {32, 2}});
    expect_sound(mesh, 0);
    EXPECT_NEAR(measure(mesh).volume, 12, 1e-5);
  }
}

TEST(Holes, WithIslandsInThemAreSeveralBodies) {
  const std::vector<Curve2> contour = {circle_contour(3), circle_contour(2), circle_contour(1)};
  const Mesh mesh = sweep(contour, straight(1), {.tessellation = {300, 2}});
  expect_sound(mesh, 2);  // a ring of 0 and a pin of 2
  EXPECT_NEAR(measure(mesh).volume, kPi * (9 - 4 + 1), 2e-2);
}

TEST(Holes, RoundALoopAndThroughAMorphStayWatertight) {
  const std::vector<Curve2> frame = {rectangle_contour(0.4, 0.4), circle_contour(0.1)};
  expect_sound(sweep(frame, circle_trajectory(2), {.tessellation = {64, 64}}), 0);
  expect_sound(sweep(frame, polyline<3>({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 1}}, true),
                     {.tessellation = {64, 64}}),
               0);
  const std::vector<Curve2> other = {star_contour(5, 0.5, 0.3), rectangle_contour(0.1, 0.2)};
  expect_sound(sweep(frame, straight(2), {.tessellation = {64, 64}, .morph = {{1, other}}}), 0);
}

TEST(Holes, InATurnedContourMakeHollowRings) {
  const auto at = [](double r) { return Curve2({ArcSegment<2>{{3, 0}, {r, 0}, {0, r}, 0, 360}}); };
  const std::vector<Curve2> ring = {at(1), at(0.5)};
  const Mesh part = revolve(ring, {.tessellation = {128, 96}, .angle_deg = 180});
  expect_sound(part, 0);
  // Pappus: the area times the way of its centroid.
  EXPECT_NEAR(measure(part).volume, kPi * 0.75 * kPi * 3, 0.05);
  const Mesh whole = revolve(ring, {.tessellation = {128, 96}});
  expect_sound(whole, 0);
}

TEST(Holes, NeedClosedOutlines) {
  const std::vector<Curve2> contour = {circle_contour(1), polyline<2>({{0, 0}, {0.5, 0}}, false)};
  try {
    sweep(contour, straight(1), {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "contour has 2 outlines, and outline 1 is open; close it, or sweep it alone");
  }
}

TEST(RoundCaps, MakeACapsuleOfACircle) {
  const Mesh mesh = sweep(circle_contour(1), straight(2), {.tessellation = {256, 4}, .caps = Caps::kRound});
  expect_sound(mesh);
  EXPECT_NEAR(measure(mesh).volume, kPi * 2 + 4 * kPi / 3, 2e-3);
  EXPECT_GT(measure(mesh).worst_normal_cosine, 0.999);
  // Every vertex of the domes lies on a sphere about an end, its normal along the radius.
  for (std::uint32_t i = 0; i < mesh.n_vertices(); ++i) {
    const glm::dvec3 p = test::position(mesh, i);
    if (p.z >= -1e-6 && p.z <= 2 + 1e-6) continue;
    const glm::dvec3 radius = p - glm::dvec3(0, 0, p.z > 1 ? 2 : 0);
    EXPECT_NEAR(glm::length(radius), 1, 1e-6);
    EXPECT_NEAR(glm::dot(glm::dvec3(mesh.normals()[i]), radius), 1, 1e-6);
  }
}

TEST(RoundCaps, CloseEveryOutlineWatertight) {
  const Law law = Law::through({{0, 1}, {1, 0.3}});
  const Curve3 bow = bezier_curve<3>({{0, 0, 0}, {1, 3, 0}, {3, 4, 2}, {5, 3, 6}});
  for (const Curve2& contour : {star_contour(5, 0.5, 0.2), rectangle_contour(0.4, 0.1),
                                polyline<2>({{0.3, 0.3}, {0.6, 0.3}, {0.6, 0.6}, {0.4, 0.7}}, true)}) {
    expect_sound(
        sweep(contour, bow, {.tessellation = {40, 40}, .caps = Caps::kRound, .profile = {law, law}}));
  }
}

TEST(RoundCaps, HaveTheirOwnTexture) {
  const Mesh mesh = sweep(circle_contour(1), straight(2), {.tessellation = {32, 4}, .caps = Caps::kRound});
  ASSERT_EQ(mesh.areas.size(), 3u);
  for (const GridPatch& patch : mesh.patches) {
    if (patch.area == 0) continue;
    EXPECT_EQ(mesh.texcoords()[patch.first_vertex].y, 0);
    EXPECT_EQ(mesh.texcoords()[patch.first_vertex + patch.vertex_count() - 1].y, 1);
  }
}

TEST(RoundCaps, AreForContoursWithoutHolesAndForSweeps) {
  const std::vector<Curve2> ring = {circle_contour(1), circle_contour(0.5)};
  EXPECT_THROW(sweep(ring, straight(1), {.caps = Caps::kRound}), InputError);
  EXPECT_THROW(revolve(rectangle_contour(1, 1), {.angle_deg = 90, .caps = Caps::kRound}), InputError);
}

}  // namespace
}  // namespace sweepkit::sweep
