// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "wall_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "sweepkit/sweep/primitives.hpp"
#include "test_shapes.hpp"

namespace sweepkit::report {
namespace {

sweep::Mesh mesh_of(const TestShape& shape, int columns) {
  return shape.make(shape.counts(columns, std::max(static_cast<int>(shape.balance * columns), 3)));
}

TEST(WallDistance, OfAPrismFromItsCylinderIsTheSagitta) {
  const sweep::Curve3 straight = sweep::polyline<3>({{0, 0, 0}, {0, 0, 3}}, false);
  const SurfaceDistance distance = [](const glm::dvec3& p, const glm::dvec2&) {
    return std::abs(std::hypot(p.x, p.y) - 1);
  };
  for (const int sides : {3, 7, 40}) {
    const sweep::Mesh mesh = sweep::sweep(sweep::circle_contour(1), straight, {.tessellation = {sides, 2}});
    // Deepest half way along a chord, which even steps look at; places are float32.
    EXPECT_NEAR(wall_distance(mesh, distance), 1 - std::cos(std::numbers::pi / sides), 2e-7) << sides;
  }
}

TEST(WallDistance, LeavesOutTheCaps) {
  const sweep::Curve3 straight = sweep::polyline<3>({{0, 0, 0}, {0, 0, 3}}, false);
  const sweep::Mesh mesh = sweep::sweep(sweep::circle_contour(1), straight, {.tessellation = {400, 2}});
  // A cap's middle would be 1 from the cylinder.
  const double found = wall_distance(
      mesh, [](const glm::dvec3& p, const glm::dvec2&) { return std::abs(std::hypot(p.x, p.y) - 1); });
  EXPECT_LT(found, 1e-4);
}

TEST(WallDistance, MissesLessThanAPercent) {
  for (const TestShape& shape : test_shapes()) {
    const sweep::Mesh mesh = mesh_of(shape, 8);
    const WallSampling everywhere{.steps = 24, .fine_steps = 24, .worst = mesh.triangles.size()};
    const double most = wall_distance(mesh, shape.distance, everywhere);
    const double found = wall_distance(mesh, shape.distance);
    EXPECT_GE(found, 0.99 * most) << shape.name;
    // The two grids have few points in common.
    EXPECT_LE(found, 1.01 * most) << shape.name;
  }
}

TEST(TestShapes, HaveEveryVertexOfTheirMeshesOnTheFormula) {
  for (const TestShape& shape : test_shapes()) {
    const sweep::Mesh mesh = mesh_of(shape, 24);
    double largest = 0;
    for (std::size_t i = 0; i < mesh.positions().size(); ++i) {
      largest = std::max(largest, shape.distance(mesh.origin + glm::dvec3(mesh.positions()[i]),
                                                 glm::dvec2(mesh.texcoords()[i])));
    }
    // The rounding to float32 of coordinates that are below the size, three of them; arc lengths are known to
    // 1e-9.
    EXPECT_LE(largest, std::sqrt(3.0) * 0x1p-24 * shape.size + 1e-8) << shape.name;
  }
}

TEST(TestShapes, AreAsFarFromMeshesByToleranceAsThoseReport) {
  for (const TestShape& shape : test_shapes()) {
    const double tolerance = 4e-3 * shape.size;
    const sweep::Mesh mesh = shape.make({.tolerance = tolerance});
    const double found = wall_distance(mesh, shape.distance);
    EXPECT_LE(found, tolerance) << shape.name;
    // Two ways of measuring: libsweep looks from the surface to the mesh, and at a part of the cells. Each
    // may miss a percent or two.
    EXPECT_NEAR(found, *mesh.deviation, 0.02 * *mesh.deviation) << shape.name;
  }
}

TEST(TestShapes, GetNearerByTheSquareOfTheCells) {
  for (const TestShape& shape : test_shapes()) {
    const double coarse = wall_distance(mesh_of(shape, 24), shape.distance);
    const double fine = wall_distance(mesh_of(shape, 48), shape.distance);
    // A chord's sagitta is a quarter for half the chord; the rest is of fourth order in the cell.
    EXPECT_NEAR(coarse / fine, 4, 0.25) << shape.name;
  }
}

}  // namespace
}  // namespace sweepkit::report
