// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Sweeps whose section changes along the way, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "mesh_measures.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep {
namespace {

using test::measure;
using test::Measures;

constexpr double kPi = std::numbers::pi;

Curve2 rectangle(double width, double height) {
  const double x = width / 2;
  const double y = height / 2;
  return polyline<2>({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, true);
}
Curve3 straight(double length) {
  return polyline<3>({{0, 0, 0}, {0, 0, length}}, false);
}

void expect_sound(const Measures& m, double least_cosine) {
  EXPECT_EQ(m.open_edges, 0u);
  EXPECT_GT(m.volume, 0);
  EXPECT_GT(m.smallest_triangle, 0);
  EXPECT_LT(m.worst_normal_length, 1e-6);
  EXPECT_GT(m.worst_normal_cosine, least_cosine);
}

// An inscribed polygon of n sides lacks a share of (2 pi / n)^2 / 6 of its circle's area.
double polygon_share(int sides) {
  return 1 - std::pow(2 * kPi / sides, 2) / 6;
}

// A twisted cell is no plane, and its diagonal lies off it: half of the tetrahedron of its corners is left
// out or added, w^2 turn length / (12 rows) over all rows for a column of width w.
double diagonals_volume(double perimeter, int columns, double turn_deg, double length, int rows) {
  return perimeter * perimeter / columns * (turn_deg * kPi / 180) * length / (12 * rows);
}

TEST(Profile, FallingToNothingMakesACone) {
  const Mesh cone = sweep(circle_contour(1), straight(2),
                          {.tessellation = {128, 16},
                           .profile = {Law::through({{0, 1}, {1, 0}}), Law::through({{0, 1}, {1, 0}})}});
  const Measures m = measure(cone);
  expect_sound(m, 0.99);
  EXPECT_EQ(m.euler, 2);
  EXPECT_TRUE(cone.patches.front().has_last_pole);
  EXPECT_EQ(cone.areas.size(), 2u) << "no cap at the tip";
  EXPECT_NEAR(m.volume, polygon_share(128) * 2 * kPi / 3, 1e-4);
  // Every normal of the wall leans forward by the cone's slope.
  for (std::size_t i = 0; i < 100; ++i) EXPECT_NEAR(cone.normals()[i].z, 1 / std::sqrt(5), 1e-6);
}

TEST(Profile, FallingFromNothingAndBackMakesASpindleOfTwoPoles) {
  const Law law = Law::through({{0, 0}, {0.5, 1}, {1, 0}});
  const Measures m = measure(sweep(circle_contour(1), straight(3), {.profile = {law, law}}));
  expect_sound(m, 0.95);
  EXPECT_EQ(m.euler, 2);
}

TEST(Profile, TouchingNothingOnTheWayMakesTwoBodiesThatMeet) {
  const Law law = Law::through({{0, 1}, {0.5, 0}, {1, 1}});
  const Mesh glass = sweep(circle_contour(1), straight(3), {.tessellation = {64, 32}, .profile = {law, law}});
  const Measures m = measure(glass);
  expect_sound(m, 0.9);
  EXPECT_EQ(glass.patches.size(), 2u);
}

TEST(Profile, RoundedByAnUprightBezierHasTheTipsNormalAlongTheTrajectory) {
  // A quarter of an ellipse, nearly: upright at the tip.
  const double k = 0.5522847498;
  const Law law = Law::bezier({{0, 0}, {0, k}, {1 - k, 1}, {1, 1}});
  const Mesh nose = sweep(circle_contour(1), straight(1), {.tessellation = {64, 64}, .profile = {law, law}});
  // The pole's vertices come first.
  for (std::size_t i = 0; i < 64; ++i) {
    EXPECT_NEAR(nose.normals()[i].z, -1, 1e-6) << i;
    EXPECT_EQ(nose.positions()[i], nose.positions()[0]);
  }
  const Measures m = measure(nose);
  EXPECT_EQ(m.open_edges, 0u);
  EXPECT_LT(m.worst_normal_length, 1e-6);
  EXPECT_NEAR(m.volume, 2 * kPi / 3, 0.02);
}

TEST(Profile, OfTwoAxesStretchesThemApart) {
  const Mesh bar = sweep(circle_contour(1), straight(1), {.tessellation = {128, 1}, .profile = {2, 0.5}});
  const Measures m = measure(bar);
  expect_sound(m, 0.99);
  EXPECT_NEAR(m.volume, polygon_share(128) * kPi, 1e-4);
  // The ellipse's normals: (x / 4, 4 y), normalized.
  for (std::size_t i = 0; i < 128; ++i) {
    const glm::dvec3 p = glm::dvec3(bar.positions()[i]) + bar.origin;
    const glm::dvec3 n = glm::normalize(glm::dvec3(p.x / 4, 4 * p.y, 0));
    EXPECT_LT(glm::length(glm::dvec3(bar.normals()[i]) - n), 1e-6) << i;
  }
}

TEST(Profile, PressedFlatOnOneAxisMakesAnEdgeWithoutTrianglesOfNoArea) {
  // A chisel: all of its front and back, nothing of its sides is left at the end. Half of the bar's volume.
  const Law falling = Law::bezier({{0, 1}, {1, 0}});
  // Cells of 1/32 m, which is exact: front and back have the same vertices along the edge.
  const Tessellation even{48, 16};
  const Mesh chisel =
      sweep(rectangle_contour(0.25, 0.5), straight(3), {.tessellation = even, .profile = {falling, 1}});
  const Measures m = measure(chisel);
  EXPECT_GT(m.smallest_triangle, 0);
  EXPECT_EQ(m.leaking_edges, 0u);
  EXPECT_EQ(m.euler, 2);
  EXPECT_NEAR(m.volume, 0.5 * 0.25 * 0.5 * 3, 1e-6);
  EXPECT_GT(m.worst_normal_cosine, 1 - 1e-6);  // it is flat all round
  // A roof leans on its short sides too.
  const Mesh roof = sweep(rectangle_contour(0.25, 0.5), straight(3),
                          {.profile = {falling, Law::bezier({{0, 1}, {1, 0.5}})}});
  EXPECT_GT(measure(roof).smallest_triangle, 0);
  EXPECT_GT(measure(roof).worst_normal_cosine, 1 - 1e-6);
  // In the middle of the way, by tolerance, with round corners, and of an open contour, which shrinks to a
  // point there.
  const Law waist = Law::through({{0, 1}, {0.5, 0}, {1, 1}});
  const Mesh bow =
      sweep(rectangle_contour(0.25, 0.5), straight(3), {.tessellation = even, .profile = {waist, 1}});
  EXPECT_GT(measure(bow).smallest_triangle, 0);
  EXPECT_EQ(measure(bow).leaking_edges, 0u);
  for (const std::optional<double> tolerance : {std::optional<double>(), std::optional<double>(1e-3)}) {
    const Mesh round = sweep(rectangle_contour(0.2, 0.4, 0.05), straight(3),
                             {.tessellation = {.tolerance = tolerance}, .profile = {1, falling}});
    EXPECT_GT(measure(round).smallest_triangle, 0);
    EXPECT_LT(measure(round).worst_normal_length, 1e-6);
  }
  const Mesh blade = sweep(polyline<2>({{-1, 0}, {1, 0}}, false), straight(3), {.profile = {falling, 1}});
  const Measures flat = measure(blade);
  EXPECT_GT(flat.smallest_triangle, 0);
  EXPECT_NEAR(flat.area, 3, 1e-6);
  EXPECT_EQ(flat.euler, 1);
}

TEST(Profile, RefusesSizesBelowNothingOrOfNothingAndLoopsThatDoNotClose) {
  EXPECT_THROW(sweep(circle_contour(1), straight(1), {.profile = {0, 0}}), InputError);
  EXPECT_THROW(sweep(polyline<2>({{-1, 0}, {1, 0}}, false), straight(1), {.profile = {0, 1}}), InputError);
  EXPECT_THROW(sweep(circle_contour(1), straight(1), {.profile = {-1, 1}}), InputError);
  EXPECT_THROW(sweep(circle_contour(1), circle_trajectory(5),
                     {.profile = {Law::through({{0, 1}, {1, 2}}), Law::through({{0, 1}, {1, 2}})}}),
               InputError);
}

TEST(Twist, KeepsTheVolumeOfABar) {
  for (const double total : {45.0, 90.0, 360.0}) {
    const Mesh bar = sweep(rectangle(2, 1), straight(4),
                           {.tessellation = {64, 256}, .twist_deg = Law::through({{0, 0}, {1, total}})});
    const Measures m = measure(bar);
    expect_sound(m, 0.98);
    EXPECT_EQ(m.euler, 2);
    // Every section has the area 2.
    EXPECT_NEAR(m.volume, 8, 1.1 * diagonals_volume(6, 64, total, 4, 256)) << total;
  }
}

TEST(Twist, HasTheNormalsOfItsOwnDerivatives) {
  // A helicoid: the x axis turning about z. Its normal at (x, angle) is (sin, -cos, x w) / sqrt(1 + (x w)^2).
  const double w = kPi / 2;
  const Mesh helicoid = sweep(polyline<2>({{0.5, 0}, {1.5, 0}}, false), straight(1),
                              {.tessellation = {10, 100}, .twist_deg = Law::through({{0, 0}, {1, 90}})});
  for (std::size_t i = 0; i < helicoid.n_vertices(); ++i) {
    const glm::dvec3 p = glm::dvec3(helicoid.positions()[i]) + helicoid.origin;
    const double r = std::hypot(p.x, p.y);
    const glm::dvec3 expected = glm::dvec3(p.y / r, -p.x / r, r * w) / std::sqrt(1 + r * r * w * w);
    const glm::dvec3 normal(helicoid.normals()[i]);
    // The right-hand side of a contour drawn along +x is -y. float32 positions and normals.
    EXPECT_LT(glm::length(normal - expected), 2e-6) << i;
  }
}

TEST(Twist, ByHalfATurnMakesAMoebiusBandOfARectangle) {
  const Mesh band = sweep(rectangle(0.1, 1), circle_trajectory(2),
                          {.tessellation = {44, 200}, .twist_deg = Law::through({{0, 0}, {1, 180}})});
  const Measures m = measure(band);
  expect_sound(m, 0.98);
  EXPECT_EQ(m.euler, 0);
  // Pappus, whatever the twist.
  EXPECT_NEAR(m.volume, 0.1 * 2 * kPi * 2, 1.1 * diagonals_volume(2.2, 44, 180, 4 * kPi, 200));
}

TEST(Twist, OnALoopEndsWhereTheSectionFitsItself) {
  for (const double total : {0.0, 90.0, 133.0, -720.0, 1000.0}) {
    const Mesh ring = sweep(rectangle(1, 1), circle_trajectory(4),
                            {.tessellation = {32, 256}, .twist_deg = Law::through({{0, 0}, {1, total}})});
    const Measures m = measure(ring);
    expect_sound(m, 0.98);
    EXPECT_EQ(m.euler, 0) << total;
  }
}

TEST(Twist, OnALoopEndsTheSameHoweverManyCellsTheContourHas) {
  // At half of the way a star of 5 points is turned by half of a fifth of a turn: there N is +X and B is +Y.
  const Law fifth = Law::bezier({{0, 0}, {1, 72}});
  for (const int cells : {10, 59, 60, 61, 64, 96}) {
    const Mesh ring = sweep(star_contour(5, 0.2, 0.1), circle_trajectory(1),
                            {.tessellation = {cells, 32}, .twist_deg = fifth});
    const Measures m = measure(ring);
    EXPECT_EQ(m.open_edges, 0u) << cells;
    EXPECT_LT(m.worst_normal_length, 1e-6) << cells;
    const glm::dvec3 tip(-1 + 0.2 * std::cos(kPi / 5), 0.2 * std::sin(kPi / 5), 0);
    double nearest = 1;
    for (std::uint32_t i = 0; i < ring.positions().size(); ++i)
      nearest = std::min(nearest, glm::distance(test::position(ring, i), tip));
    EXPECT_LT(nearest, 1e-6) << cells;
    // Sides of a star are as many as its cells, or a multiple of them.
    EXPECT_LT(ring.triangles.size(), 2u * 32u * static_cast<unsigned>(cells + 10)) << cells;
  }
  // Nothing is added where nothing comes home turned.
  EXPECT_EQ(
      sweep(star_contour(5, 0.2, 0.1), circle_trajectory(1), {.tessellation = {64, 32}}).triangles.size(),
      2u * 64u * 32u);
  EXPECT_EQ(sweep(circle_contour(0.1), torus_knot(2, 3, 1, 0.4), {.tessellation = {10, 32}}).triangles.size(),
            2u * 10u * 32u);
}

TEST(Twist, TogetherWithAProfileStaysSound) {
  const Law swell = Law::through({{0, 1}, {0.3, 1.6}, {0.7, 0.6}, {1, 1}});
  const Curve3 way = bezier_curve<3>({{0, 0, 0}, {2, 6, 0}, {8, -4, 3}, {10, 2, 0}});
  const Mesh body = sweep(rectangle(0.6, 0.4), way,
                          {.tessellation = {48, 400},
                           .profile = {swell, 1.2},
                           .twist_deg = Law::through({{0, 0}, {0.5, 300}, {1, 90}})});
  expect_sound(measure(body), 0.97);
}

}  // namespace
}  // namespace sweepkit::sweep
