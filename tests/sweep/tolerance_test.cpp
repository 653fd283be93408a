// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// The surface itself is sampled by sweeps of very many cells: their vertices lie on it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cuts.hpp"
#include "mesh_measures.hpp"
#include "surface_distance.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep {
namespace {

using test::largest_distance;
using test::measure;
using test::Measures;

constexpr double kPi = std::numbers::pi;

struct Case {
  const char* name;
  Curve2 contour;
  Curve3 trajectory;
  SweepOptions options;
  double size;  // metres, of the whole
};

std::vector<Case> cases() {
  const Law spindle = Law::through({{0, 0}, {0.5, 1}, {1, 0}});
  const Law turn = Law::through({{0, 0}, {1, 180}});
  const Curve3 straight = polyline<3>({{0, 0, 0}, {0, 0, 3}}, false);
  const Curve3 bow = bezier_curve<3>({{0, 0, 0}, {1, 3, 0}, {3, 4, 2}, {5, 3, 6}});
  return {
      {"cylinder", circle_contour(1), straight, {}, 3},
      {"torus", circle_contour(0.3), circle_trajectory(1), {}, 2.6},
      {"knot", circle_contour(0.15), torus_knot(2, 3, 1, 0.4), {}, 3},
      {"twisted bow", rectangle_contour(0.3, 0.2, 0.05), bow, {.twist_deg = turn}, 8},
      {"Moebius band", rectangle_contour(1, 0.1), circle_trajectory(1), {.twist_deg = turn}, 3},
      {"pipe",
       circle_contour(0.1),
       polyline<3>({{0, 0, 0}, {0, 0, 3}, {0, 2, 3}}, false),
       {.joints = Joints::kRound},
       3.5},
      {"mitre",
       rectangle_contour(0.2, 0.1),
       polyline<3>({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, true),
       {},
       2},
      {"spindle", circle_contour(0.3), straight, {.profile = {spindle, spindle}}, 3},
      {"morph",
       star_contour(5, 0.5, 0.2),
       straight,
       {.morph = {{0.5, {circle_contour(0.4)}}, {1, {rectangle_contour(0.5, 0.3)}}}},
       3},
      {"drawn backwards", bezier_curve<2>({{0, 0}, {0, 1}, {3, 1}, {1, -1}, {0, 0}}), bow, {}, 8},
  };
}

Mesh fitted(const Case& c, double tolerance) {
  SweepOptions options = c.options;
  options.tessellation.tolerance = tolerance;
  return sweep(c.contour, c.trajectory, options);
}

Mesh counted(const Case& c, int columns, int rows) {
  SweepOptions options = c.options;
  options.tessellation = {columns, rows};
  options.has_half_edges = false;
  return sweep(c.contour, c.trajectory, options);
}

TEST(Tolerance, IsNeverExceededByDenseSampling) {
  for (const Case& c : cases()) {
    // An even number, for the Moebius band to close half turned as it does by tolerance.
    const Mesh surface = counted(c, 300, 701);
    for (const double share : {1e-2, 1e-3, 1e-4}) {
      const double tolerance = share * c.size;
      const Mesh mesh = fitted(c, tolerance);
      ASSERT_TRUE(mesh.deviation);
      EXPECT_LE(*mesh.deviation, tolerance) << c.name << ' ' << share;
      const double found = largest_distance(surface, mesh);
      EXPECT_LE(found, tolerance) << c.name << ' ' << share;
      // What is reported was measured well: it may be more than what is found, being from closer looks at the
      // worst cells and with the rounding of float32, and hardly less: of the others a 16th part is looked
      // at.
      EXPECT_LE(found, *mesh.deviation * (1 + 1.0 / 32) + 1e-7 * c.size) << c.name << ' ' << share;
    }
  }
}

TEST(Tolerance, MeshesAreWatertightWithoutFlatTriangles) {
  for (const Case& c : cases()) {
    const Measures m = measure(fitted(c, 1e-3 * c.size));
    EXPECT_EQ(m.open_edges, 0u) << c.name;
    EXPECT_EQ(m.euler, c.trajectory.is_closed() ? 0 : 2) << c.name;
    EXPECT_GT(m.smallest_triangle, 0) << c.name;
    EXPECT_LT(m.worst_normal_length, 1e-6) << c.name;
    EXPECT_GT(m.volume, 0) << c.name;
  }
}

TEST(Tolerance, SpendsNothingOnWhatIsStraight) {
  const Mesh box = sweep(rectangle_contour(1, 1), polyline<3>({{0, 0, 0}, {0, 0, 3}}, false),
                         {.tessellation = {.tolerance = 1e-3}});
  // Four sides, the seam in the middle of one of them.
  EXPECT_EQ(box.triangles.size(), 10u + 2 * 3);
  const Mesh pipe = sweep(circle_contour(0.1), polyline<3>({{0, 0, 0}, {0, 0, 3}, {0, 2, 3}}, false),
                          {.tessellation = {.tolerance = 1e-3}});
  EXPECT_EQ(test::WallGrid(pipe).cells() % 2, 0u) << "two rows of cells, one a leg";
  EXPECT_LT(test::WallGrid(pipe).cells(), 2u * 30);
}

TEST(Tolerance, CutsACircleIntoTheFewestChords) {
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const Mesh mesh = sweep(circle_contour(1), polyline<3>({{0, 0, 0}, {0, 0, 3}}, false),
                            {.tessellation = {.tolerance = tolerance}});
    const double fewest = kPi / std::acos(1 - tolerance);
    // Columns lie on the places of a finer division, eleven to a cell at least.
    EXPECT_LE(static_cast<double>(test::WallGrid(mesh).cells()), fewest * (1 + 1.0 / 11) + 1);
    EXPECT_GE(static_cast<double>(test::WallGrid(mesh).cells()), fewest - 1e-9);
  }
}

// The fewest cells by counts alone: for every number of columns the least number of rows that fits.
std::size_t fewest_by_search(const Case& c, double tolerance, std::size_t chosen_cells) {
  // Even, for the Moebius band to close half turned as it does by tolerance.
  const Mesh surface = counted(c, 160, 203);
  const int least_rows = c.trajectory.is_closed() ? 3 : 1;
  std::size_t fewest = chosen_cells * 4;
  const auto fits = [&](int columns, int rows) {
    const Mesh mesh = counted(c, columns, rows);
    // One row of cells between two poles has no surface.
    return !mesh.triangles.empty() && largest_distance(surface, mesh) <= tolerance;
  };
  for (double columns = 3; columns < 600; columns *= 1.1) {
    const int n = 2 * static_cast<int>(columns / 2 + 1);
    int low = least_rows - 1;
    int high = static_cast<int>(fewest / static_cast<std::size_t>(n));
    if (high < least_rows || !fits(n, high)) continue;
    while (high - low > 1 + high / 64) {
      const int middle = (low + high) / 2;
      (fits(n, middle) ? high : low) = middle;
    }
    fewest = std::min(fewest, test::WallGrid(counted(c, n, high)).cells());
  }
  return fewest;
}

TEST(Tolerance, TakesNoMoreThanAQuarterMoreThanTheBestOfAllCounts) {
  for (const Case& c : cases()) {
    const double tolerance = 1e-3 * c.size;
    const std::size_t chosen = test::WallGrid(fitted(c, tolerance)).cells();
    const std::size_t fewest = fewest_by_search(c, tolerance, chosen);
    EXPECT_LE(static_cast<double>(chosen), 1.25 * static_cast<double>(fewest)) << c.name;
    RecordProperty(c.name, std::to_string(chosen) + " of " + std::to_string(fewest));
  }
}

TEST(Tolerance, OfARevolvedContourIsHeldToo) {
  const std::vector<Curve2> contours = {
      Curve2({ArcSegment<2>{{0, 0}, {1, 0}, {0, 1}, -90, 90}}),     // a sphere
      bezier_curve<2>({{0, 0}, {1, 0}, {0.2, 1.5}, {0.6, 2}}),      // a vase
      Curve2({ArcSegment<2>{{2, 0}, {0.5, 0}, {0, 0.5}, 0, 360}}),  // a torus
      polyline<2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, false),         // a can
  };
  for (const Curve2& contour : contours) {
    const Mesh surface = revolve(contour, {.tessellation = {601, 701}, .has_half_edges = false});
    for (const double tolerance : {2e-2, 2e-3, 2e-4}) {
      const Mesh mesh = revolve(contour, {.tessellation = {.tolerance = tolerance}});
      EXPECT_LE(*mesh.deviation, tolerance);
      const double found = largest_distance(surface, mesh);
      EXPECT_LE(found, tolerance);
      EXPECT_LE(found, *mesh.deviation * (1 + 1.0 / 64) + 3e-7);
      const Measures m = measure(mesh);
      EXPECT_GT(m.smallest_triangle, 0);
    }
  }
}

TEST(Tolerance, CoarserThanTheObjectLeavesAClosedMeshAllTheSame) {
  for (const Case& c : cases()) {
    const Measures m = measure(fitted(c, 10 * c.size));
    EXPECT_EQ(m.open_edges, 0u) << c.name;
    EXPECT_GT(m.smallest_triangle, 0) << c.name;
  }
  const Measures m = measure(revolve(Curve2({ArcSegment<2>{{0, 0}, {1, 0}, {0, 1}, -90, 90}}),
                                     {.tessellation = {.tolerance = 100}}));
  EXPECT_EQ(m.open_edges, 0u);
  EXPECT_EQ(m.euler, 2);
}

TEST(Tolerance, SaysWhatItRefuses) {
  const auto problem = [](double tolerance, double radius) {
    try {
      sweep(circle_contour(radius), polyline<3>({{0, 0, 0}, {0, 0, 3}}, false),
            {.tessellation = {.tolerance = tolerance}});
    } catch (const InputError& error) {
      return error.problem();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(problem(0, 1), "tolerance needs to be above 0 m, got 0");
  EXPECT_EQ(problem(-1, 1), "tolerance needs to be above 0 m, got -1");
  EXPECT_EQ(problem(1e-12, 1),
            "tolerance of 1e-12 m would need too many cells along the contour; ask for a larger one");
  EXPECT_NE(problem(1e-7, 1).find("finer than float32 positions of an object so large; ask for at least"),
            std::string::npos);
}

TEST(Cut, TakesTheFewestChordsOfAParabola) {
  // A chord over n places of y = x^2 is off by about (n / 2)^2.
  const auto error = [](std::size_t a, std::size_t b) {
    const double n = static_cast<double>(b - a);
    return n * n / 4;
  };
  const std::vector<std::size_t> cuts = cut(10, 110, 1, error, 25);
  EXPECT_EQ(cuts, (std::vector<std::size_t>{10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110}));
  EXPECT_EQ(cut(0, 100, 1, error, 1e9), (std::vector<std::size_t>{0, 100}));
  EXPECT_EQ(cut(0, 100, 4, error, 1e9), (std::vector<std::size_t>{0, 25, 50, 75, 100}));
  EXPECT_EQ(cut(0, 3, 1, error, 0), (std::vector<std::size_t>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace sweepkit::sweep
