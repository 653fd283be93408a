// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh_measures.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

using test::measure;
using test::Measures;

constexpr double kPi = std::numbers::pi;

Curve2 square(double half) {
  return polyline<2>({{-half, -half}, {half, -half}, {half, half}, {-half, half}}, true);
}

// Promises of every closed sweep: watertight by position, outwards, no zero area, unit normals that agree
// with the faces.
void expect_sound(const Mesh& mesh, double least_cosine) {
  const Measures m = measure(mesh);
  EXPECT_EQ(m.open_edges, 0u);
  EXPECT_GT(m.volume, 0);
  EXPECT_GT(m.smallest_triangle, 0);
  EXPECT_LT(m.worst_normal_length, 1e-6);
  EXPECT_GT(m.worst_normal_cosine, least_cosine);
}

TEST(Sweep, TorusHasThePappusVolumeAndArea) {
  for (const int cells : {64, 128}) {
    const Mesh torus = sweep(circle_contour(0.3), circle_trajectory(1), {.tessellation = {cells, 2 * cells}});
    const Measures m = measure(torus);
    // An inscribed polygon of n sides lacks a share of (2 pi / n)^2 / 6 of its circle's area; both circles
    // take part.
    const double share = 1.5 * std::pow(2 * kPi / cells, 2) / 6;
    EXPECT_NEAR(m.volume, 2 * kPi * kPi * 0.09, share * 2 * kPi * kPi * 0.09);
    EXPECT_NEAR(m.area, 4 * kPi * kPi * 0.3, share * 4 * kPi * kPi * 0.3);
    EXPECT_EQ(m.euler, 0);
    expect_sound(torus, 0.99);
  }
}

TEST(Sweep, CapsATubeAndKeepsTheSectionPerpendicular) {
  const Mesh tube =
      sweep(circle_contour(1), polyline<3>({{0, 0, 0}, {0, 0, 2}}, false), {.tessellation = {64, 3}});
  expect_sound(tube, 0.99);
  EXPECT_EQ(measure(tube).euler, 2);
  EXPECT_EQ(tube.areas.size(), 3u);
  EXPECT_EQ(tube.triangles.size(), 64u * 3 * 2 + 2 * 62);
}

TEST(Sweep, TurnsAClockwiseContourSoThatTheOutsideIsOut) {
  const Curve2 clockwise = polyline<2>({{0, 0}, {0, 1}, {1, 1}, {1, 0}}, true);
  const Mesh bar = sweep(clockwise, polyline<3>({{0, 0, 0}, {0, 3, 0}}, false), {.tessellation = {4, 1}});
  expect_sound(bar, 0.999999);
  EXPECT_NEAR(measure(bar).volume, 3, 1e-6);
}

TEST(Sweep, MitresAClosedFrameWithItsSectionKept) {
  const Mesh frame = sweep(square(0.1), polyline<3>({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, true),
                           {.tessellation = {4, 4}});
  expect_sound(frame, 0.999999);
  EXPECT_EQ(measure(frame).euler, 0);
  // Pappus: section 0.2 x 0.2 along a square of side 2.
  EXPECT_NEAR(measure(frame).volume, 0.04 * 8, 1e-6);
}

TEST(Sweep, MitresStayInOrderHoweverManyRingsStandNearThem) {
  const Mesh pipe =
      sweep(circle_contour(0.4), polyline<3>({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}, false),
            {.tessellation = {32, 300}});
  expect_sound(pipe, 0.99);
  // A mitred pipe has its section's area along the axis: the inner side loses what the outer gains.
  const double polygon = 0.5 * 32 * 0.16 * std::sin(2 * kPi / 32);
  EXPECT_NEAR(measure(pipe).volume, 3 * polygon, 1e-6);
}

TEST(Sweep, RefusesAMitreAtAReversal) {
  EXPECT_THROW(sweep(circle_contour(0.1), polyline<3>({{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}, false)),
               InputError);
}

TEST(Sweep, CapsAConcaveContourWithItsArea) {
  const Curve2 arrow = polyline<2>({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}}, true);
  for (const int cells : {5, 20, 100}) {
    const Mesh bar = sweep(arrow, polyline<3>({{0, 0, 0}, {0, 3, 0}}, false), {.tessellation = {cells, 2}});
    expect_sound(bar, 0.999);
    EXPECT_NEAR(measure(bar).volume, 7.5, 1e-5);
  }
}

TEST(Sweep, SeamsHaveTheSameBitsInPositionAndNormal) {
  const Mesh knot =
      sweep(circle_contour(0.1), free_curve<3>({{1, 0, 0}, {0, 0.5, 1}, {-1, -0.5, 0.2}, {0, 0.3, -1}}, true),
            {.tessellation = {16, 40}});
  const GridPatch& patch = knot.patches.at(0);
  for (std::uint32_t j = 0; j <= patch.rows; ++j) {
    EXPECT_EQ(knot.positions()[patch.vertex(0, j)], knot.positions()[patch.vertex(patch.columns, j)]);
    EXPECT_EQ(knot.normals()[patch.vertex(0, j)], knot.normals()[patch.vertex(patch.columns, j)]);
    EXPECT_EQ(knot.texcoords()[patch.vertex(0, j)].x, 0.0f);
    EXPECT_EQ(knot.texcoords()[patch.vertex(patch.columns, j)].x, 1.0f);
  }
  for (std::uint32_t i = 0; i <= patch.columns; ++i) {
    EXPECT_EQ(knot.positions()[patch.vertex(i, 0)], knot.positions()[patch.vertex(i, patch.rows)]);
    EXPECT_EQ(knot.normals()[patch.vertex(i, 0)], knot.normals()[patch.vertex(i, patch.rows)]);
  }
  EXPECT_EQ(knot.areas.at(0).u_period, 1);
  EXPECT_EQ(knot.areas.at(0).v_period, 1);
}

TEST(Sweep, NormalsAgreeWithFiniteDifferencesOfTheSurface) {
  // A fine mesh's own neighbours stand in for the derivatives: central differences over 2/1000 of a turn.
  const Curve3 path = free_curve<3>({{1, 0, 0}, {0, 0.5, 1}, {-1, -0.5, 0.2}, {0, 0.3, -1}}, true);
  const Mesh mesh = sweep(circle_contour(0.1), path, {.tessellation = {256, 4096}});
  const GridPatch& patch = mesh.patches.at(0);
  double worst = 0;
  for (std::uint32_t j = 1; j < patch.rows; j += 37) {
    for (std::uint32_t i = 1; i < patch.columns; i += 5) {
      const auto at = [&](std::uint32_t c, std::uint32_t r) {
        return test::position(mesh, patch.vertex(c, r));
      };
      const glm::dvec3 normal =
          glm::normalize(glm::cross(at(i + 1, j) - at(i - 1, j), at(i, j + 1) - at(i, j - 1)));
      worst = std::max(worst, glm::length(normal - glm::dvec3(mesh.normals()[patch.vertex(i, j)])));
    }
  }
  // float32 positions 3e-8 off over chords of 3e-3 turn a normal by 3e-5; the joints of the free curve, where
  // its curvature jumps, add the difference's own error.
  EXPECT_LT(worst, 2e-4);
}

TEST(Sweep, NormalsFollowTheTwistThatClosesAMitredLoop) {
  // The contour stands beside the trajectory, so that the twist swings it round.
  // Four straight pieces that do not lie in a plane: the closing twist turns each section as it goes, and
  // between two mitres the rings lean over. Central differences along and across show the surface as it is.
  const Mesh mesh = sweep(Curve2({ArcSegment<2>{{0.2, 0.1}, {0.3, 0}, {0, 0.3}, 0, 360}}),
                          polyline<3>({{0, 0, 0}, {2, 0, 0}, {2.5, 2, 1.5}, {0, 2, -1}}, true),
                          {.tessellation = {64, 400}});
  ASSERT_EQ(mesh.patches.size(), 4u);
  double worst = 0;
  for (const GridPatch& patch : mesh.patches) {
    for (std::uint32_t j = 1; j < patch.rows; ++j) {
      for (std::uint32_t i = 1; i < patch.columns; i += 5) {
        const auto at = [&](std::uint32_t c, std::uint32_t r) {
          return test::position(mesh, patch.vertex(c, r));
        };
        const glm::dvec3 normal =
            glm::normalize(glm::cross(at(i + 1, j) - at(i - 1, j), at(i, j + 1) - at(i, j - 1)));
        worst = std::max(worst, glm::length(normal - glm::dvec3(mesh.normals()[patch.vertex(i, j)])));
      }
    }
  }
  // float32 positions are up to 1.2e-7 off a coordinate: two ends of a chord of 5e-2 turn it by up to 1e-5.
  // The differences themselves are exact across (a circle's chord is parallel to its tangent), and nearly so
  // along.
  EXPECT_LT(worst, 1e-5);
  expect_sound(mesh, 0.99);
}

TEST(Sweep, BreaksNormalsAtCreasesAndOnlyThere) {
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
  EXPECT_EQ(sweep(square(1), line, {.tessellation = {4, 1}}).patches.size(), 4u);
  EXPECT_EQ(sweep(square(1), line, {.tessellation = {4, 1}, .crease_deg = 100}).patches.size(), 1u);
}

TEST(Sweep, TextureRunsByLengthAndRepeatsAsAsked) {
  const Curve3 path = polyline<3>({{0, 0, 0}, {0, 0, 1}, {0, 0, 4}}, false);
  const Mesh mesh =
      sweep(circle_contour(1), path, {.tessellation = {8, 2}, .uv = {.repeat = {3, 2}}, .caps = Caps::kNone});
  const GridPatch& patch = mesh.patches.at(0);
  EXPECT_EQ(mesh.texcoords()[patch.vertex(4, 0)], glm::vec2(1.5, 0));
  EXPECT_EQ(mesh.texcoords()[patch.vertex(8, 2)], glm::vec2(3, 2));
}

TEST(Sweep, UvIsRightHandedSeenFromOutside) {
  const Mesh mesh = sweep(circle_contour(0.3), circle_trajectory(1), {.tessellation = {16, 32}});
  for (const Triangle& t : mesh.triangles) {
    const glm::vec2 a = mesh.texcoords()[t[0]];
    const glm::vec2 b = mesh.texcoords()[t[1]];
    const glm::vec2 c = mesh.texcoords()[t[2]];
    EXPECT_GT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0);
    EXPECT_EQ(a.x, b.x);  // the right angle is at B
    EXPECT_EQ(b.y, c.y);
  }
}

TEST(Sweep, KeepsItsPrecisionFarFromTheOrigin) {
  const glm::dvec3 far(1e7, -1e7, 1e7);
  const Mesh mesh = sweep(circle_contour(0.01), polyline<3>({far, far + glm::dvec3(0, 0, 1)}, false),
                          {.tessellation = {64, 8}});
  // Relative to the mesh's own origin a float32 keeps the section to 1e-7 of a metre; double at 1e7 rounds to
  // 2e-9.
  const GridPatch& patch = mesh.patches.at(0);
  for (std::uint32_t i = 0; i <= patch.columns; ++i) {
    const glm::dvec3 p = test::position(mesh, patch.vertex(i, 0)) - far;
    EXPECT_NEAR(glm::length(p), 0.01, 2e-7);
  }
}

TEST(Sweep, ScalesByPowersOfTwoToTheBit) {
  const auto knot = [](double s) {
    std::vector<glm::dvec3> points = {{1, 0, 0}, {0, 0.5, 1}, {-1, -0.5, 0.2}, {0, 0.3, -1}};
    for (glm::dvec3& p : points) p *= s;
    return sweep(circle_contour(0.1 * s), free_curve<3>(points, true), {.tessellation = {12, 24}});
  };
  const Mesh one = knot(1);
  for (const double s : {0x1p-10, 0x1p10}) {
    const Mesh other = knot(s);
    for (std::size_t i = 0; i < one.n_vertices(); ++i) {
      EXPECT_EQ(one.positions()[i] * static_cast<float>(s), other.positions()[i]);
      EXPECT_EQ(one.normals()[i], other.normals()[i]);
    }
  }
}

TEST(Sweep, RefusesCountsOutOfRange) {
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
  EXPECT_THROW(sweep(circle_contour(1), line, {.tessellation = {0, 1}}), InputError);
  EXPECT_THROW(sweep(circle_contour(1), line, {.tessellation = {4, -1}}), InputError);
  EXPECT_THROW(sweep(circle_contour(1), line, {.tessellation = {kMaxCells + 1, 1}}), InputError);
  EXPECT_THROW(sweep(circle_contour(1), line, {.tessellation = {kMaxCells, kMaxCells}}), InputError);
}

}  // namespace
}  // namespace sweepkit::sweep
