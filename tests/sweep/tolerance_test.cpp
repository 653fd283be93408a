// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cuts.hpp"
#include "mesh_measures.hpp"
#include "surface_distance.hpp"
#include "sweepkit/error.hpp"
#include "tolerance_cases.hpp"

namespace sweepkit::sweep {
namespace {

using test::Case;
using test::cases;
using test::fitted;
using test::measure;
using test::Measures;

constexpr double kPi = std::numbers::pi;

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

// A sphere within 1e-4 m takes 156 cells round and half as many up: some 24,000 triangles.
TEST(Tolerance, IsRefusedWhereItTakesMoreTrianglesThanThereMayBe) {
  const Curve2 half_circle({ArcSegment<2>{{0, 0}, {1, 0}, {0, 1}, -90, 90}});
  const auto problem = [](auto&& make) {
    try {
      make();
    } catch (const InputError& error) {
      return error.problem();
    }
    return std::string("nothing");
  };
  const auto revolved = [&](std::uint64_t most) {
    return problem(
        [&] { revolve(half_circle, {.tessellation = {.tolerance = 1e-4, .most_triangles = most}}); });
  };
  EXPECT_EQ(revolved(1000000), "nothing");
  EXPECT_EQ(revolved(1000).rfind("tolerance of 0.0001 m takes ", 0), 0u) << revolved(1000);
  EXPECT_NE(
      revolved(1000).find(
          " triangles, more than the 1000 that memory and the file have room for; ask for a larger one"),
      std::string::npos);
  const auto swept = [&](std::uint64_t most) {
    return problem([&] {
      sweep(circle_contour(1), helix(3, 1, 2), {.tessellation = {.tolerance = 1e-3, .most_triangles = most}});
    });
  };
  EXPECT_EQ(swept(10000000), "nothing");
  EXPECT_NE(swept(100).find(
                " triangles, more than the 100 that memory and the file have room for; ask for a larger one"),
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
