// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mesh_measures.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"

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

TEST(Sweep, SmoothSeamCornersHaveTheSameBitsToo) {
  // A crease angle above every bend: one patch whose first and last row stand on a mitre of a twisted loop.
  const Mesh loop = sweep(Curve2({ArcSegment<2>{{0.2, 0.1}, {0.3, 0}, {0, 0.3}, 0, 360}}),
                          polyline<3>({{0, 0, 0}, {2, 0, 0}, {2.5, 2, 1.5}, {0, 2, -1}}, true),
                          {.tessellation = {12, 24}, .crease_deg = 180});
  ASSERT_EQ(loop.patches.size(), 1u);
  const GridPatch& patch = loop.patches[0];
  for (std::uint32_t i = 0; i <= patch.columns; ++i) {
    EXPECT_EQ(loop.positions()[patch.vertex(i, 0)], loop.positions()[patch.vertex(i, patch.rows)]);
    EXPECT_EQ(loop.normals()[patch.vertex(i, 0)], loop.normals()[patch.vertex(i, patch.rows)]);
  }
  EXPECT_EQ(measure(loop).open_edges, 0u);
}

TEST(Sweep, NormalsStayFiniteAndUnitWhereTheSurfaceShrinksToAPoint) {
  // A horn torus: all rings meet in the middle.
  const Mesh horn = sweep(circle_contour(1), circle_trajectory(1), {.tessellation = {16, 32}});
  EXPECT_LT(measure(horn).worst_normal_length, 1e-6);
  // A contour that turns right back on itself, at any crease angle; a trajectory with a cusp and a closed one
  // with a bend far tighter than the contour is wide.
  const Curve2 hook = polyline<2>({{0, 0}, {1, 0}, {0.5, 0}}, false);
  const Curve3 cusp = bezier_curve<3>({{1, -1, 0}, {-1.0 / 3, 1, 0}, {-1.0 / 3, -1, 0}, {1, 1, 0}});
  const Curve3 tight = free_curve<3>({{0, 0, 0}, {1, 0, 0}, {1, 0.01, 0.01}, {0, 0.3, 0.5}}, true);
  for (const Curve3& path : {cusp, tight}) {
    for (const Curve2& contour : {hook, circle_contour(0.7)}) {
      const Mesh mesh = sweep(contour, path, {.tessellation = {16, 64}, .crease_deg = 180});
      for (std::size_t i = 0; i < mesh.n_vertices(); ++i) {
        ASSERT_NEAR(glm::length(glm::dvec3(mesh.normals()[i])), 1, 1e-6);
        ASSERT_TRUE(std::isfinite(glm::dot(mesh.positions()[i], glm::vec3(1))));
      }
    }
  }
}

TEST(Sweep, RandomTubesAreSound) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 60; ++round) {
    // A star-shaped outline drawn either way round, thin beside a trajectory of 4 to 9 points.
    const bool is_smooth = round % 3 != 0;
    const bool is_loop = round % 4 < 2;
    const int sides = 3 + round % 9;
    std::vector<glm::dvec2> outline;
    for (int i = 0; i < sides; ++i) {
      const double angle = (round % 2 == 0 ? 2 : -2) * kPi * i / sides;
      const double r = 0.02 + 0.01 * unit(random);
      outline.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    std::vector<glm::dvec3> path;
    const int points = 4 + round % 6;
    for (int i = 0; i < points; ++i) {
      const double angle = 2 * kPi * i / (is_loop ? points : points + 2);
      path.push_back({std::cos(angle), 0.3 * unit(random), std::sin(angle)});
    }
    const Curve2 contour = is_smooth ? free_curve<2>(outline, true) : polyline<2>(outline, true);
    const Curve3 trajectory = round % 5 < 3 ? free_curve<3>(path, is_loop) : polyline<3>(path, is_loop);
    const Mesh tube = sweep(contour, trajectory, {.tessellation = {sides + round % 30, points + 2 * round}});
    const Measures m = measure(tube);
    EXPECT_EQ(m.open_edges, 0u) << round;
    EXPECT_EQ(m.euler, is_loop ? 0 : 2) << round;
    EXPECT_GT(m.volume, 0) << round;
    EXPECT_GT(m.smallest_triangle, 0) << round;
    EXPECT_LT(m.worst_normal_length, 1e-6) << round;
    std::uint32_t triangles = 0;
    for (const Area& area : tube.areas) {
      EXPECT_EQ(area.first_triangle, triangles);
      triangles += area.triangle_count;
    }
    EXPECT_EQ(triangles, tube.triangles.size());
  }
}

TEST(Sweep, SaysWhatItRefusesAndWhatWouldDo) {
  const Curve2 circle = circle_contour(1);
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
  const auto message = [&](const Curve2& contour, const Curve3& trajectory, const SweepOptions& options) {
    try {
      sweep(contour, trajectory, options);
    } catch (const InputError& error) {
      return error.problem();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(message(circle, line, {.tessellation = {-3, 1}}),
            "tessellation along the contour needs 1 to 32768 cells, got -3");
  EXPECT_EQ(message(circle, line, {.tessellation = {2, 1}}),
            "contour is closed and needs at least 3 cells, got 2");
  EXPECT_EQ(message(circle, circle_trajectory(5), {.tessellation = {8, 2}}),
            "trajectory is closed and needs at least 3 cells, got 2");
  EXPECT_EQ(message(polyline<2>({{0, 0}, {1, 1}, {3, 3}, {2, 2}}, true), line, {}),
            "closed contour lies on one straight line and encloses nothing; open it or move a point aside");
  EXPECT_EQ(message(circle, line, {.crease_deg = -1}), "crease_deg needs to be 0 to 180, got -1");
  EXPECT_EQ(message(circle, line, {.crease_deg = std::nan("")}), "crease_deg needs to be 0 to 180, got nan");
  EXPECT_EQ(message(circle, line, {.uv = {.repeat = {1, HUGE_VAL}}}),
            "uv repeat needs two finite numbers, got 1 and inf");
  EXPECT_EQ(message(circle, polyline<3>({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, false), {}),
            "trajectory turns back on itself at 2 m along it; no joint bends that sharply: lead it round");
  EXPECT_EQ(message(circle, line, {.miter_limit = 0.5}), "miter_limit needs to be 1 or more, got 0.5");
  EXPECT_EQ(message(circle, line, {.tessellation = {kMaxCells, kMaxCells}}),
            "has too many triangles for 32-bit indices; ask for fewer cells");
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
