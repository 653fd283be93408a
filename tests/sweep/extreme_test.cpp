// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Stiff and extreme input: each case is right to the promised numbers, or a finding, or refused with its
// reason; never NaN.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include "mesh_measures.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/finding.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep {
namespace {

using test::measure;
using test::Measures;

constexpr double kPi = std::numbers::pi;
constexpr Frames kAllFrames[] = {Frames::kRotationMinimizing, Frames::kFrenet, Frames::kFixedUp};

std::vector<Finding> check(const Curve2& contour, const Curve3& trajectory,
                           const SweepOptions& options = {}) {
  return check_sweep(std::span(&contour, 1), trajectory, options);
}

const Finding* find(const std::vector<Finding>& findings, FindingKind kind) {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [kind](const Finding& finding) { return finding.kind == kind; });
  return found == findings.end() ? nullptr : &*found;
}

template <class Make>
std::string refusal_of(Make&& make) {
  try {
    make();
  } catch (const InputError& error) {
    return error.problem();
  }
  return "made";
}

// Nothing but finite numbers, unit normals, a closed surface.
void expect_sound(const Mesh& mesh) {
  for (const glm::vec3& p : mesh.positions()) {
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
  for (const glm::vec2& uv : mesh.texcoords()) ASSERT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
  const Measures measures = measure(mesh);
  EXPECT_EQ(measures.open_edges, 0u);
  EXPECT_LT(measures.worst_normal_length, 1e-6);
  EXPECT_GT(measures.smallest_triangle, 0);
}

void expect_same_positions(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.positions().size(), b.positions().size());
  for (std::size_t i = 0; i < a.positions().size(); ++i) ASSERT_EQ(a.positions()[i], b.positions()[i]) << i;
}

// The largest distance between vertices of one number, `b` scaled.
double largest_difference(const Mesh& a, const Mesh& b, double scale) {
  EXPECT_EQ(a.positions().size(), b.positions().size());
  double largest = 0;
  for (std::uint32_t i = 0; i < a.positions().size(); ++i)
    largest = std::max(largest, glm::distance(test::position(a, i), scale * test::position(b, i)));
  return largest;
}

Curve2 contour_moved_aside(std::vector<std::vector<glm::dvec2>> segments) {
  for (std::vector<glm::dvec2>& segment : segments) {
    for (glm::dvec2& point : segment) point.x += 2;
  }
  return joined_bezier_curve<2>(segments);
}

TEST(Extreme, CuspsAreFoundAndLeaveTheMeshSound) {
  // The semicubical parabola (t^2, t^3), and a cubic whose control polygon crosses itself.
  const Curve3 semicubical = bezier_curve<3>({{1, -1, 0}, {-1.0 / 3, 1, 0}, {-1.0 / 3, -1, 0}, {1, 1, 0}});
  const Curve3 crossed = bezier_curve<3>({{0, 0, 0}, {1, 0, 1}, {0, 0, 1}, {1, 0, 0}});
  for (const Curve3* curve : {&semicubical, &crossed}) {
    for (const Frames frames : kAllFrames) {
      SweepOptions options{.orientation = {.frames = frames}};
      expect_sound(sweep(circle_contour(1e-3), *curve, options));
      const std::vector<Finding> findings = check(circle_contour(1e-3), *curve, options);
      const Finding* cusp = find(findings, FindingKind::kCusp);
      ASSERT_NE(cusp, nullptr);
      EXPECT_NEAR(cusp->t, 0.5, 1e-6);
      EXPECT_EQ(find(findings, FindingKind::kFold), nullptr);  // no size would cure it
      EXPECT_NEAR(cusp->severity, 180, 1);
      options.tessellation.tolerance = 1e-3;
      expect_sound(sweep(circle_contour(1e-2), *curve, options));
    }
  }
}

TEST(Extreme, ACurveOnALineThatTurnsBackHasTwoCusps) {
  const Curve3 curve = bezier_curve<3>({{0, 0, 0}, {2, 0, 0}, {-1, 0, 0}, {1, 0, 0}});
  for (const Frames frames : kAllFrames) {
    const SweepOptions options{.orientation = {.frames = frames}};
    expect_sound(sweep(circle_contour(0.05), curve, options));
    int cusps = 0;
    for (const Finding& finding : check(circle_contour(0.05), curve, options)) {
      if (finding.kind != FindingKind::kCusp) continue;
      ++cusps;
      EXPECT_NEAR(finding.severity, 180, 1e-6);
    }
    EXPECT_EQ(cusps, 2);
  }
}

TEST(Extreme, TrajectoriesThatTurnRightBackAtACornerAreRefused) {
  for (const double aside : {0.0, 1e-12, 1e-9}) {
    EXPECT_NE(refusal_of([&] {
                sweep(circle_contour(0.05), polyline<3>({{0, 0, 0}, {1, 0, 0}, {0.5, 0, aside}}, false));
              }).find("trajectory turns back on itself at 1 m along it"),
              std::string::npos);
  }
  // A quarter of a degree less is a bevel.
  const Curve3 sharp = polyline<3>({{0, 0, 0}, {1, 0, 0}, {0.5, 0, 2.2e-3}}, false);
  const Mesh mesh = sweep(circle_contour(0.05), sharp);
  EXPECT_LT(measure(mesh).worst_normal_length, 1e-6);
}

TEST(Extreme, SegmentsWithoutLengthChangeNothing) {
  const std::vector<glm::dvec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {2, 1, 1}};
  std::vector<glm::dvec3> repeated;
  for (const glm::dvec3& point : points) repeated.insert(repeated.end(), 3, point);
  expect_same_positions(sweep(circle_contour(0.05), polyline<3>(points, false)),
                        sweep(circle_contour(0.05), polyline<3>(repeated, false)));
  expect_same_positions(sweep(circle_contour(0.05), free_curve<3>(points, false)),
                        sweep(circle_contour(0.05), free_curve<3>(repeated, false)));
  const std::vector<glm::dvec3> bend = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
  const std::vector<glm::dvec3> point(4, bend.back());
  expect_same_positions(sweep(circle_contour(0.05), bezier_curve<3>(bend)),
                        sweep(circle_contour(0.05), joined_bezier_curve<3>({bend, point, point})));
}

TEST(Extreme, PointsThatDifferByRoundingAreRepeatedOnes) {
  const double most = 1 + std::numeric_limits<double>::epsilon();
  const Mesh mesh =
      sweep(circle_contour(0.05),
            free_curve<3>(
                {{0, 0, 0}, {1e-300, 0, 0}, {1, 0, 0}, {most, 0, 1e-200}, {1, 0, 1}, {1, 5e-324, 1}}, false));
  expect_sound(mesh);
  expect_same_positions(mesh,
                        sweep(circle_contour(0.05), free_curve<3>({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, false)));
}

TEST(Extreme, CoincidentControlPointsLeaveALineALine) {
  // Both run from (0,0,0) to (1,1,0), the first at a speed that is 0 at its ends.
  const Curve3 resting = bezier_curve<3>({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}});
  const Curve3 line = polyline<3>({{0, 0, 0}, {1, 1, 0}}, false);
  for (const Frames frames : {Frames::kRotationMinimizing, Frames::kFixedUp}) {
    const SweepOptions options{.orientation = {.frames = frames}};
    const Mesh mesh = sweep(circle_contour(0.05), resting, options);
    expect_sound(mesh);
    // float32 rounds coordinates up to 1 by 6e-8.
    EXPECT_LT(largest_difference(mesh, sweep(circle_contour(0.05), line, options), 1), 3e-7);
  }
}

TEST(Extreme, Degree64IsTheParabolaItWasRaisedFrom) {
  // The control points of (x, x^2), x = i / n, raised to degree n: x^2 has the coefficients i (i-1) / n
  // (n-1).
  constexpr int kDegree = 64;
  std::vector<glm::dvec3> raised;
  for (int i = 0; i <= kDegree; ++i) {
    raised.push_back({i / 64.0, static_cast<double>(i) * (i - 1) / (kDegree * (kDegree - 1.0)), 0});
  }
  const Curve3 parabola = bezier_curve<3>({{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}});
  EXPECT_NEAR(bezier_curve<3>(raised).length(), parabola.length(), 1e-13);
  for (const Frames frames : kAllFrames) {
    const SweepOptions options{.orientation = {.frames = frames}};
    const Mesh mesh = sweep(circle_contour(0.05), bezier_curve<3>(raised), options);
    expect_sound(mesh);
    EXPECT_LT(largest_difference(mesh, sweep(circle_contour(0.05), parabola, options), 1), 3e-7);
  }
}

TEST(Extreme, ATorusOfCurvatureAMillionHasItsVolume) {
  const double ring = 1e-6;
  const double tube = 1e-7;
  const Mesh mesh =
      sweep(circle_contour(tube), circle_trajectory(ring), {.tessellation = {.tolerance = 1e-4 * ring}});
  expect_sound(mesh);
  const Measures measures = measure(mesh);
  EXPECT_NEAR(measures.volume, 2 * kPi * kPi * ring * tube * tube, measures.area * *mesh.deviation);
}

TEST(Extreme, ABendOfCurvatureAMillionIsAFoldWithItsCure) {
  // Two lines and a quarter circle of a thousandth of a millimetre between them: 2e-6 of the way.
  const double ring = 1e-6;
  const Curve3 curve({BezierSegment<3>{{{0, 0, 1}, {0, 0, 0}}},
                      ArcSegment<3>{{ring, 0, 0}, {-ring, 0, 0}, {0, 0, -ring}, 0, 90},
                      BezierSegment<3>{{{ring, 0, -ring}, {1, 0, -ring}}}});
  expect_sound(sweep(circle_contour(1e-7), curve));
  EXPECT_EQ(find(check(circle_contour(0.999 * ring), curve), FindingKind::kFold), nullptr);
  const std::vector<Finding> findings = check(circle_contour(0.1), curve);
  const Finding* fold = find(findings, FindingKind::kFold);
  ASSERT_NE(fold, nullptr);
  EXPECT_NEAR(fold->severity, 0.1 / ring, 1e-6 * 0.1 / ring);
  EXPECT_NEAR(fold->t, 0.5, 1e-5);
  EXPECT_EQ(fold->cure, "the contour fits when made 1e-05 times as large");
}

TEST(Extreme, FrenetFramesGoThroughInflectionsThatAreAlmostStraightWithoutAFlip) {
  for (const double height : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    const Curve3 curve =
        bezier_curve<3>({{-1, -height, 0}, {-1.0 / 3, height, 0}, {1.0 / 3, -height, 0}, {1, height, 0}});
    const Mesh mesh = sweep(circle_contour(0.05), curve, {.orientation = {.frames = Frames::kFrenet}});
    expect_sound(mesh);
    const GridPatch& wall = mesh.patches.front();
    const std::size_t columns = 65;
    for (std::size_t j = 0; j < 64; ++j) {
      for (std::size_t i = 0; i < columns; ++i) {
        const glm::vec3 step = mesh.positions()[wall.first_vertex + (j + 1) * columns + i] -
                               mesh.positions()[wall.first_vertex + j * columns + i];
        // Rows are 2 / 64 apart or a little more; a flip would carry a point by 0.1.
        ASSERT_LT(glm::length(step), 0.05) << height << " row " << j;
      }
    }
  }
}

TEST(Extreme, SizesFromANanometreToAMillionKilometresGiveTheSameShape) {
  const auto shapes = [](double size, const SweepOptions& options) {
    std::vector<Mesh> meshes;
    meshes.push_back(sweep(circle_contour(0.3 * size), circle_trajectory(size), options));
    meshes.push_back(sweep(star_contour(5, 0.2 * size, 0.1 * size),
                           bezier_curve<3>({{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {size, size, size}}),
                           options));
    meshes.push_back(sweep(rectangle_contour(0.2 * size, 0.1 * size, 0.02 * size),
                           polyline<3>({{0, 0, 0}, {size, 0, 0}, {size, size, 0}}, false), options));
    meshes.push_back(revolve(bezier_curve<2>({{0, 0}, {size, 0}, {size, size}, {0, 2 * size}}),
                             {.tessellation = options.tessellation}));
    return meshes;
  };
  const std::vector<Mesh> metres = shapes(1, {});
  for (const double size : {1e-9, 1e9, 1e-29, 1e37}) {
    const std::vector<Mesh> sized = shapes(size, {});
    for (std::size_t i = 0; i < sized.size(); ++i) {
      expect_sound(sized[i]);
      // Float32's rounding of coordinates up to 2, and of the size itself.
      EXPECT_LT(largest_difference(sized[i], metres[i], size), 1e-6 * size) << size << " " << i;
    }
    for (const Mesh& mesh : shapes(size, {.tessellation = {.tolerance = 1e-3 * size}})) {
      expect_sound(mesh);
      EXPECT_LE(*mesh.deviation, 1e-3 * size);
    }
  }
}

TEST(Extreme, WhatFloat32CannotHoldIsRefused) {
  const auto torus = [](double size) {
    return refusal_of([=] { sweep(circle_contour(size), circle_trajectory(3 * size)); });
  };
  EXPECT_EQ(torus(1e-40), "is 8e-40 m large; float32 positions need it between 1e-30 and 1e+38 m");
  EXPECT_EQ(torus(1e40), "is 8e+40 m large; float32 positions need it between 1e-30 and 1e+38 m");
  const double denormal = std::numeric_limits<double>::denorm_min();
  for (const double size : {denormal, 1e-310, 1e-160, 1e-100, 1e100, 1e150, 1e160, 1e300, 1e308}) {
    EXPECT_NE(torus(size), "made") << size;
    EXPECT_NE(refusal_of([=] {
                revolve(polyline<2>({{0, 0}, {size, 0}, {0, size}}, false));
              }),
              "made")
        << size;
    for (const bool is_free : {false, true}) {
      const std::vector<glm::dvec3> points = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}};
      EXPECT_NE(refusal_of([&] {
                  sweep(circle_contour(0.1 * size),
                        is_free ? free_curve<3>(points, false) : polyline<3>(points, false));
                }),
                "made")
          << size;
    }
  }
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {infinity, -infinity, nan}) {
    EXPECT_NE(torus(bad), "made");
    EXPECT_NE(refusal_of([=] { polyline<3>({{0, 0, 0}, {bad, 0, 1}}, false); }), "made");
    EXPECT_NE(refusal_of([=] { free_curve<3>({{0, 0, 0}, {bad, 0, 1}, {1, 1, 1}}, true); }), "made");
    EXPECT_NE(refusal_of([=] { bezier_curve<3>({{0, 0, 0}, {bad, 0, 1}, {1, 1, 1}}); }), "made");
    EXPECT_NE(refusal_of([=] { helix(1, bad, 3); }), "made");
    EXPECT_NE(refusal_of([=] { helix(1, 1, bad); }), "made");
    EXPECT_NE(refusal_of([=] { Law{bad}; }), "made");
  }
}

TEST(Extreme, CoordinatesAtTenThousandKilometresKeepTheShapeAndAreFound) {
  const glm::dvec3 far(1e7, -1e7, 1e7);
  const std::vector<glm::dvec3> near = {{0, 0, 0}, {1, 0, 1}, {0, 2, 3}, {4, 0, 5}};
  std::vector<glm::dvec3> moved;
  for (const glm::dvec3& point : near) moved.push_back(far + point);
  const Mesh here = sweep(circle_contour(0.1), bezier_curve<3>(near));
  const Mesh there = sweep(circle_contour(0.1), bezier_curve<3>(moved));
  expect_sound(there);
  double largest = 0;
  for (std::uint32_t i = 0; i < here.positions().size(); ++i)
    largest = std::max(largest, glm::distance(test::position(there, i), far + test::position(here, i)));
  // Doubles at 1e7 are 1.9e-9 apart and float32 at 5 (relative to the origin chosen) 4.8e-7.
  EXPECT_LT(largest, 2e-6);
  EXPECT_NE(find(check(circle_contour(0.1), bezier_curve<3>(moved)), FindingKind::kPrecision), nullptr);
}

TEST(Extreme, ASectionThatFloat32LosesAlongALargeObjectIsFound) {
  EXPECT_EQ(find(check(circle_contour(1e-3), circle_trajectory(100)), FindingKind::kPrecision), nullptr);
  for (const double ring : {1e4, 1e9}) {
    const std::vector<Finding> findings = check(circle_contour(1e-3), circle_trajectory(ring));
    ASSERT_NE(find(findings, FindingKind::kPrecision), nullptr) << ring;
  }
}

TEST(Extreme, NeedlesAreMeasuredAndMadeToTolerance) {
  for (const double thin : {1e-3, 1e-6, 1e-9}) {
    const Curve2 ellipse = ellipse_contour(1, thin);
    // 4 a E(e); for the thinnest 1 - e^2 is lost in e, and 4 + 2 b^2 (ln(4 / b) - 1/2) is exact.
    const double exact = thin < 1e-4 ? 4 + 2 * thin * thin * (std::log(4 / thin) - 0.5)
                                     : 4 * std::comp_ellint_2(std::sqrt(1 - thin * thin));
    EXPECT_NEAR(ellipse.length(), exact, 1e-9 * exact) << thin;
    const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
    expect_sound(sweep(ellipse, line));
    const Mesh mesh = sweep(ellipse, line, {.tessellation = {.tolerance = 1e-4}});
    expect_sound(mesh);
    EXPECT_NEAR(measure(mesh).volume, kPi * thin, measure(mesh).area * 1e-4);
  }
}

TEST(Extreme, ArcLengthIsRightToNineDigitsWhereTheSpeedAlmostVanishes) {
  // (t, t^2 / 2w): the speed has a kink w wide. Its closed form, as a quadratic Bezier curve over [-1, 1].
  for (const double width : {1e-1, 1e-3, 1e-6, 1e-9}) {
    const double rise = 1 / (2 * width);
    const Curve2 parabola = bezier_curve<2>({{-1, rise}, {0, -rise}, {1, rise}});
    const long double u = 1.0L / width;
    const long double exact = width * (u * std::sqrt(1 + u * u) + std::asinh(u));
    EXPECT_NEAR(parabola.length() / static_cast<double>(exact), 1, 1e-9) << width;
    // Half of the way is the vertex.
    EXPECT_NEAR(parabola.evaluate(parabola.locate(0.5 * parabola.length())).position.x, 0,
                1e-9 * width + 1e-12)
        << width;
  }
}

TEST(Extreme, AHundredThousandPointsAreSweptByCountsAndByTolerance) {
  std::vector<glm::dvec3> spiral;
  std::vector<glm::dvec2> gear;
  constexpr int kPoints = 100000;
  for (int i = 0; i < kPoints; ++i) {
    const double a = 1e-3 * i;
    spiral.push_back({(1 + 0.01 * a) * std::cos(a), 0.05 * a, (1 + 0.01 * a) * std::sin(a)});
    const double b = 2 * kPi * i / kPoints;
    gear.push_back((1 + 0.1 * std::cos(40 * b)) * glm::dvec2(std::cos(b), std::sin(b)));
  }
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
  for (const bool is_free : {false, true}) {
    const Curve3 trajectory = is_free ? free_curve<3>(spiral, false) : polyline<3>(spiral, false);
    const Curve2 contour = is_free ? free_curve<2>(gear, true) : polyline<2>(gear, true);
    const Measures wire = measure(sweep(circle_contour(0.01), trajectory, {.tessellation = {8, 4096}}));
    EXPECT_EQ(wire.open_edges, 0u);
    // An octagon along the way.
    EXPECT_NEAR(wire.volume, 8 * 0.5 * 1e-4 * std::sin(kPi / 4) * trajectory.length(), 1e-3 * wire.volume);
    const Measures rod = measure(sweep(contour, line, {.tessellation = {4096, 4}}));
    EXPECT_EQ(rod.open_edges, 0u);
    // r = 1 + 0.1 cos 40 b encloses pi (1 + 0.1^2 / 2).
    EXPECT_NEAR(rod.volume, kPi * 1.005, 1e-3);
  }
  const SweepOptions fine{.tessellation = {.tolerance = 1e-3}};
  const Mesh wire = sweep(circle_contour(0.01), free_curve<3>(spiral, false), fine);
  const Measures measures = measure(wire);
  EXPECT_EQ(measures.open_edges, 0u);
  EXPECT_LE(*wire.deviation, 1e-3);
  EXPECT_LT(wire.triangles.size(), 60000u);
  const Mesh rod = sweep(free_curve<2>(gear, true), line, fine);
  EXPECT_NEAR(measure(rod).volume, kPi * 1.005, measure(rod).area * 1e-3);
  EXPECT_LT(rod.triangles.size(), 4000u);
}

TEST(Extreme, LawsOfAnySteepnessKeepTheMeshFinite) {
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
  const Law step = Law::through({{0, 1}, {0.5, 1}, {0.5 + 1e-12, 1e-9}, {1, 1e-9}});
  expect_sound(sweep(circle_contour(0.1), line, {.profile = {step, step}}));
  const Law spin = Law::through({{0, 0}, {1, 3.6e8}});
  const Mesh spun = sweep(circle_contour(0.1), line, {.twist_deg = spin});
  EXPECT_LT(measure(spun).worst_normal_length, 1e-6);
  const Law needle = Law::through({{0, 1}, {0.5, 0}, {1, 1}});
  const Mesh pinched = sweep(circle_contour(0.1), line, {.profile = {needle, needle}});
  EXPECT_LT(measure(pinched).worst_normal_length, 1e-6);
  EXPECT_GT(measure(pinched).smallest_triangle, 0);
}

TEST(Extreme, ContoursWithCuspsAndSlitsAreSweptSoundly) {
  // An astroid: four cusps, as cubics whose ends rest.
  std::vector<std::vector<glm::dvec2>> arcs;
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 from(std::cos(i * kPi / 2), std::sin(i * kPi / 2));
    const glm::dvec2 to(-from.y, from.x);
    arcs.push_back({from, 0.4 * from, 0.4 * to, to});
  }
  arcs.back().back() = arcs.front().front();
  for (std::size_t i = 1; i < 4; ++i) arcs[i].front() = arcs[i - 1].back();
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
  expect_sound(sweep(joined_bezier_curve<2>(arcs), line));
  expect_sound(sweep(joined_bezier_curve<2>(arcs), line, {.tessellation = {.tolerance = 1e-3}}));
  // A cusp in the middle of a segment: the semicubical parabola (t^2, t^3), closed by a line; a cubic whose
  // control polygon crosses itself, scaled to coordinates that are not whole; a quartic.
  const std::vector<std::vector<std::vector<glm::dvec2>>> hooks = {
      {{{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}, {{1, 1}, {1, -1}}},
      {{{0, 0}, {0.7, 0.3}, {0, 0.3}, {0.7, 0}}, {{0.7, 0}, {0, 0}}},
      {{{0, 0}, {1, 0}, {0.4, 1}, {0, 0.5}, {1, 0.1}}}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Curve2 contour = joined_bezier_curve<2>(hooks[i]);
    int corners = 0;
    for (std::size_t k = 0; k < contour.segments().size(); ++k) corners += contour.is_corner(k) ? 1 : 0;
    EXPECT_EQ(corners, 3);  // the cusp and both ends of the line
    for (const std::optional<double> tolerance : {std::optional<double>(), std::optional<double>(1e-3)}) {
      const Mesh mesh = sweep(contour, line, {.tessellation = {.tolerance = tolerance}});
      expect_sound(mesh);
      // Neighbouring columns bend by less than half a right angle, the cusp's sides by none.
      EXPECT_GT(measure(mesh).worst_normal_cosine, std::cos(kPi / 4));
    }
    EXPECT_GT(measure(revolve(contour_moved_aside(hooks[i]))).worst_normal_cosine, std::cos(kPi / 4));
  }
  // Slow, but not at rest: one segment, as it was.
  EXPECT_EQ(bezier_curve<2>(hooks[2].front()).segments().size(), 1u);
  // A slit a billionth wide.
  const Curve2 slit = polyline<2>(
      {{0, 0}, {1, 0}, {1, 0.5}, {0.1, 0.5}, {0.1, 0.5 + 1e-9}, {1, 0.5 + 1e-9}, {1, 1}, {0, 1}}, true);
  const Measures measures = measure(sweep(slit, line));
  EXPECT_LT(measures.worst_normal_length, 1e-6);
  EXPECT_NEAR(measures.volume, 1, 1e-6);
  EXPECT_NE(refusal_of([&] { sweep(polyline<2>({{0, 0}, {1, 0}, {2, 0}}, true), line); }), "made");
}

}  // namespace
}  // namespace sweepkit::sweep
