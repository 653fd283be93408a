// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh_measures.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep {
namespace {

using test::measure;
using test::Measures;

constexpr double kPi = std::numbers::pi;

Curve2 half_circle(double radius) {
  return Curve2({ArcSegment<2>{{0, 0}, {radius, 0}, {0, radius}, -90, 90}});
}

TEST(Revolve, MakesASphereWithItsVolumeAndExactNormals) {
  const Mesh sphere = revolve(half_circle(1), {.tessellation = {64, 128}});
  const Measures m = measure(sphere);
  EXPECT_EQ(m.open_edges, 0u);
  EXPECT_EQ(m.euler, 2);
  EXPECT_GT(m.smallest_triangle, 0);
  EXPECT_EQ(sphere.triangles.size(), 128u * (2 * 64 - 2));
  // Inscribed: a share of about (2 pi / 128)^2 is lacking.
  EXPECT_NEAR(m.volume, 4 * kPi / 3, 2.5e-3 * 4 * kPi / 3);
  for (std::size_t i = 0; i < sphere.n_vertices(); ++i) {
    // On the unit sphere normal and position are one; both are rounded to float32.
    EXPECT_LT(glm::length(sphere.positions()[i] - sphere.normals()[i]), 2e-7f);
  }
}

TEST(Revolve, GivesAPoleTheTextureOfItsTrianglesRightAngle) {
  const Mesh sphere = revolve(half_circle(1), {.tessellation = {8, 16}});
  const GridPatch& patch = sphere.patches.at(0);
  EXPECT_TRUE(patch.has_first_pole && patch.has_last_pole);
  for (const Triangle& t : sphere.triangles) {
    EXPECT_EQ(sphere.texcoords()[t[0]].x, sphere.texcoords()[t[1]].x);
    EXPECT_EQ(sphere.texcoords()[t[1]].y, sphere.texcoords()[t[2]].y);
  }
}

TEST(Revolve, HasPappusVolumeOfAClosedContour) {
  // A square of side 1 whose middle is 1.5 from the axis; the turn of n sides has n sin(2 pi / n) / (2 pi) of
  // it.
  const Curve2 square = polyline<2>({{1, 0}, {2, 0}, {2, 1}, {1, 1}}, true);
  const Mesh ring = revolve(square, {.tessellation = {4, 360}});
  const double polygon = 360 * std::sin(2 * kPi / 360) / (2 * kPi);
  EXPECT_NEAR(measure(ring).volume, 2 * kPi * 1.5 * polygon, 1e-5);
  EXPECT_EQ(measure(ring).open_edges, 0u);
  const Mesh clockwise =
      revolve(polyline<2>({{1, 1}, {2, 1}, {2, 0}, {1, 0}}, true), {.tessellation = {4, 360}});
  EXPECT_NEAR(measure(clockwise).volume, measure(ring).volume, 1e-5);
}

TEST(Revolve, CapsAPartOfATurn) {
  const Mesh wedge = revolve(polyline<2>({{1, 0}, {2, 0}, {2, 1}, {1, 1}}, true),
                             {.tessellation = {4, 90}, .angle_deg = 90});
  const Measures m = measure(wedge);
  EXPECT_EQ(m.open_edges, 0u);
  EXPECT_EQ(m.euler, 2);
  EXPECT_NEAR(m.volume, kPi / 2 * 1.5, 1e-3);
  EXPECT_GT(m.worst_normal_cosine, 0.999);
}

TEST(Revolve, AVaseDrawnUpwardsFacesOutwardsWithUToTheRight) {
  const Mesh pipe = revolve(polyline<2>({{1, 0}, {1, 2}}, false), {.tessellation = {1, 32}});
  for (std::size_t i = 0; i < pipe.n_vertices(); ++i) {
    const glm::vec3 p = pipe.positions()[i];
    EXPECT_GT(glm::dot(glm::vec3(p.x, 0, p.z), pipe.normals()[i]), 0.99f);
  }
  // Seen from +x with +y up, right is -z: there u is just above 0.
  const GridPatch& patch = pipe.patches.at(0);
  EXPECT_LT(pipe.positions()[patch.vertex(1, 0)].z, 0);
}

TEST(Revolve, RingsCloseBitForBitAndAreFourfoldSymmetric) {
  const Mesh pipe = revolve(polyline<2>({{0.1, 0}, {0.3, 2}}, false), {.tessellation = {3, 40}});
  const GridPatch& patch = pipe.patches.at(0);
  for (std::uint32_t j = 0; j <= patch.rows; ++j) {
    EXPECT_EQ(pipe.positions()[patch.vertex(0, j)], pipe.positions()[patch.vertex(40, j)]);
    for (std::uint32_t i = 0; i <= 30; ++i) {
      const glm::vec3 p = pipe.positions()[patch.vertex(i, j)];
      EXPECT_EQ(glm::vec3(p.z, p.y, -p.x), pipe.positions()[patch.vertex(i + 10, j)]);
      EXPECT_EQ(glm::vec3(p.x, p.y, -p.z), pipe.positions()[patch.vertex(40 - i, j)]);
    }
  }
}

TEST(Revolve, SplitsAtAPointOnTheAxisInTheMiddle) {
  // An hourglass: two cones that meet in one point.
  const Mesh glass = revolve(polyline<2>({{1, 0}, {0, 1}, {1, 2}}, false), {.tessellation = {8, 16}});
  EXPECT_EQ(glass.patches.size(), 2u);
  EXPECT_GT(measure(glass).smallest_triangle, 0);
}

TEST(Revolve, LeavesOutWhatLiesOnTheAxis) {
  const Mesh disc = revolve(polyline<2>({{0, 1}, {0, 0}, {1, 0}}, false), {.tessellation = {2, 16}});
  EXPECT_EQ(disc.triangles.size(), 16u);
  EXPECT_GT(measure(disc).smallest_triangle, 0);
}

TEST(Revolve, RefusesWhatItCannotTurn) {
  EXPECT_THROW(revolve(polyline<2>({{-1, 0}, {1, 1}}, false)), InputError);
  EXPECT_THROW(revolve(polyline<2>({{0, 0}, {0, 1}}, false)), InputError);
  EXPECT_THROW(revolve(half_circle(1), {.angle_deg = 0}), InputError);
  EXPECT_THROW(revolve(half_circle(1), {.angle_deg = 361}), InputError);
  EXPECT_THROW(revolve(half_circle(1), {.tessellation = {8, 2}}), InputError);
}

TEST(Revolve, SaysWhatItRefusesAndWhatWouldDo) {
  const auto message = [](const Curve2& contour, const RevolveOptions& options) {
    try {
      revolve(contour, options);
    } catch (const InputError& error) {
      return error.problem();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(
      message(polyline<2>({{-0.5, 3}, {1, 1}}, false), {}),
      "contour crosses the axis: x is -0.5 m at height 3 m; keep x, the distance from it, at 0 or above");
  EXPECT_EQ(message(half_circle(1), {.tessellation = {1, 8}}),
            "contour has all its 2 vertices on the axis; move it away from x = 0 or give it more cells");
  EXPECT_EQ(message(half_circle(1), {.angle_deg = 400}),
            "angle_deg needs to be above 0 and at most 360, got 400");
  EXPECT_EQ(message(half_circle(1), {.tessellation = {8, 2}}),
            "the whole turn is closed and needs at least 3 cells, got 2");
  EXPECT_EQ(message(half_circle(1), {.tessellation = {8, 40000}}),
            "tessellation along the turn needs 1 to 32768 cells, got 40000");
}

TEST(Revolve, AClosedContourOnTheAxisGivesASolidWithoutInnerWalls) {
  // A half disc whose straight side is the axis: a whole turn gives the ball, half a turn half of it with two
  // caps.
  const Curve2 half_disc(
      {ArcSegment<2>{{0, 0}, {1, 0}, {0, 1}, -90, 90}, BezierSegment<2>{{{0, 1}, {0, -1}}}});
  const Measures ball = measure(revolve(half_disc, {.tessellation = {96, 128}}));
  EXPECT_EQ(ball.open_edges, 0u);
  EXPECT_EQ(ball.euler, 2);
  EXPECT_GT(ball.smallest_triangle, 0);
  const Measures half = measure(revolve(half_disc, {.tessellation = {96, 64}, .angle_deg = 180}));
  EXPECT_EQ(half.open_edges, 0u);
  EXPECT_EQ(half.euler, 2);
  EXPECT_NEAR(half.volume, ball.volume / 2, 1e-5);
}

TEST(Revolve, VolumeConvergesInSecondOrder) {
  // Pappus: an ellipse of half axes 0.5 and 1 about an axis 2 away has 2 pi 2 times pi 0.5.
  const Curve2 ellipse({ArcSegment<2>{{2, 0}, {0.5, 0}, {0, 1}, 0, 360}});
  const double exact = 2 * kPi * 2 * kPi * 0.5;
  double before = 0;
  for (const int cells : {32, 64, 128}) {
    const double error = exact - measure(revolve(ellipse, {.tessellation = {cells, cells}})).volume;
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.05) << cells;
    }
    before = error;
  }
}

TEST(Plane, FacesUpWithUAlongXAndVAlongMinusZ) {
  const Mesh floor = plane({2, 3}, {.tessellation = {3, 4}, .uv = {.repeat = {5, 7}}});
  const GridPatch& patch = floor.patches.at(0);
  EXPECT_EQ(floor.positions()[patch.vertex(0, 0)], glm::vec3(-1, 0, 1.5));
  EXPECT_EQ(floor.texcoords()[patch.vertex(3, 4)], glm::vec2(5, 7));
  EXPECT_EQ(measure(floor).worst_normal_cosine, 1);
  EXPECT_NEAR(measure(floor).area, 6, 1e-6);
  EXPECT_THROW(plane({0, 1}), InputError);
}

}  // namespace
}  // namespace sweepkit::sweep
