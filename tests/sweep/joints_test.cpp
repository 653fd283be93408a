// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Tubes round corners. Every section is centred on its trajectory, so by Pappus' theorem (and for mitres
// because a wedge cut off on one side is added on the other) a tube's volume is the section's area times the
// length of the joined trajectory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "joints.hpp"
#include "mesh_measures.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep {
namespace {

using test::measure;
using test::Measures;

constexpr double kPi = std::numbers::pi;

// Down a leg of 3 m along x, round a corner, and 3 m on.
Curve3 elbow(double turn_deg, double leg = 3) {
  const double a = turn_deg * kPi / 180;
  return polyline<3>({{-leg, 0, 0}, {0, 0, 0}, {leg * std::cos(a), leg * std::sin(a), 0}}, false);
}

// 0.2 by 0.2; its corners lie 0.1 sqrt 2 from the trajectory.
const Curve2 kSquare = rectangle_contour(0.2, 0.2);
const double kReach = 0.1 * std::numbers::sqrt2;

JoinedTrajectory join(const Curve3& trajectory, Joints joints, double limit = 4, double reach = kReach) {
  return join_corners(trajectory, joints, limit, [reach](double) { return reach; });
}

Mesh tube(const Curve3& trajectory, Joints joints, int cells = 64, double limit = 4) {
  return sweep(kSquare, trajectory,
               {.tessellation = {8, cells}, .joints = joints, .miter_limit = limit, .orientation = {}});
}

void expect_watertight(const Mesh& mesh) {
  const Measures m = measure(mesh);
  EXPECT_EQ(m.open_edges, 0u);
  EXPECT_EQ(m.euler, mesh.areas.size() == 1 ? 0 : 2);
  EXPECT_GT(m.smallest_triangle, 0);
  EXPECT_LT(m.worst_normal_length, 1e-6);
}

// How far the tube's vertices lie from the axis of the elbow's first leg, of those within it.
struct Extent {
  double width = 0;
  double height = 0;
};
Extent extent_of_first_leg(const Mesh& mesh, double until_x) {
  Extent extent;
  for (std::uint32_t i = 0; i < mesh.n_vertices(); ++i) {
    const glm::dvec3 p = test::position(mesh, i);
    if (p.x > until_x || std::abs(p.y) > 0.5) continue;  // behind the corner, or on the other leg
    extent.width = std::max(extent.width, std::abs(p.y));
    extent.height = std::max(extent.height, std::abs(p.z));
  }
  return extent;
}

TEST(Joints, OfEveryKindAreWatertightAndKeepTheSectionOnBothLegs) {
  for (const double turn : {20.0, 90.0, 130.0, 150.0}) {
    for (const Joints joints : {Joints::kMiter, Joints::kSmooth, Joints::kRound, Joints::kBevel}) {
      const Curve3 path = elbow(turn);
      const Mesh mesh = tube(path, joints);
      expect_watertight(mesh);
      const Extent extent = extent_of_first_leg(mesh, -2);
      EXPECT_NEAR(extent.width, 0.1, 1e-6) << turn;
      EXPECT_NEAR(extent.height, 0.1, 1e-6) << turn;
      const double length = join(path, joints).curve.length();
      // A round joint's sections turn by at most 15 degrees a cell; flat cells in the place of an arc lack up
      // to 1 - sin(15 degrees) / 15 degrees of it.
      const double bend = joints == Joints::kRound ? 0.04 * turn * kPi / 180 * 2 * kReach : 0;
      EXPECT_NEAR(measure(mesh).volume, 0.04 * length, 1e-6 + bend * 0.0114) << turn;
    }
  }
}

TEST(Joints, RoundOnesAreArcsOfTwiceTheReachThatTouchBothLegs) {
  const JoinedTrajectory joined = join(elbow(90), Joints::kRound);
  ASSERT_EQ(joined.curve.segments().size(), 3u);
  EXPECT_FALSE(joined.curve.is_corner(1));
  EXPECT_FALSE(joined.curve.is_corner(2));
  const double radius = 2 * kReach;
  EXPECT_NEAR(joined.curve.length(), 2 * (3 - radius) + kPi / 2 * radius, 1e-12);
  EXPECT_EQ(joined.least_cells, (std::vector<int>{1, 6, 1})) << "15 degrees a cell";
  const glm::dvec3 center(-radius, radius, 0);
  for (const double t : {0.0, 0.3, 0.5, 1.0}) {
    EXPECT_NEAR(glm::length(joined.curve.evaluate({1, t}).position - center), radius, 1e-12);
  }
}

TEST(Joints, BevelledOnesHaveTwoCornersOfHalfTheTurn) {
  const JoinedTrajectory joined = join(elbow(120), Joints::kBevel);
  ASSERT_EQ(joined.curve.segments().size(), 3u);
  for (const std::size_t i : {1u, 2u}) {
    ASSERT_TRUE(joined.curve.is_corner(i));
    EXPECT_NEAR(glm::dot(joined.curve.tangent({i - 1, 1}), joined.curve.tangent({i, 0})), 0.5, 1e-12);
  }
  // The chord's inner side is left a little length by the two mitres, so nothing folds.
  const double chord =
      glm::length(joined.curve.evaluate({1, 1}).position - joined.curve.evaluate({1, 0}).position);
  EXPECT_GT(chord, 2 * kReach * std::tan(kPi / 6));
  EXPECT_LT(chord, 1.2 * 2 * kReach * std::tan(kPi / 6));
}

TEST(Joints, MitresBeyondTheLimitBecomeBevels) {
  // A mitre of turn d is 1 / cos(d / 2) sections long: 4 at 151.04 degrees.
  EXPECT_EQ(join(elbow(150.9), Joints::kMiter).curve.segments().size(), 2u);
  EXPECT_EQ(join(elbow(151.2), Joints::kMiter).curve.segments().size(), 3u);
  EXPECT_EQ(join(elbow(151.2), Joints::kSmooth).curve.segments().size(), 3u);
  EXPECT_EQ(join(elbow(90), Joints::kMiter, 1.4).curve.segments().size(), 3u);
  EXPECT_EQ(join(elbow(90), Joints::kMiter, 1.5).curve.segments().size(), 2u);
  expect_watertight(tube(elbow(179), Joints::kMiter));
}

TEST(Joints, TakeNoMoreOfALegThanThereIs) {
  // A staircase of legs far shorter than the section is wide.
  std::vector<glm::dvec3> steps = {{-1, 0, 0}};
  for (int i = 0; i < 10; ++i) steps.emplace_back(0.02 * ((i + 1) / 2), 0.02 * (i / 2), 0);
  steps.emplace_back(2, 0.1, 0);
  for (const Joints joints : {Joints::kRound, Joints::kBevel}) {
    const JoinedTrajectory joined = join(polyline<3>(steps, false), joints);
    EXPECT_GT(joined.curve.length(), 2.5);
    const Measures m = measure(tube(polyline<3>(steps, false), joints, 100));
    EXPECT_EQ(m.open_edges, 0u);
    EXPECT_LT(m.worst_normal_length, 1e-6);
  }
}

TEST(Joints, OfAClosedTrajectoryJoinItsSeamToo) {
  const Curve3 frame = polyline<3>({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, true);
  for (const Joints joints : {Joints::kMiter, Joints::kSmooth, Joints::kRound, Joints::kBevel}) {
    const JoinedTrajectory joined = join(frame, joints);
    EXPECT_TRUE(joined.curve.is_closed());
    const Mesh mesh = tube(frame, joints, 200);
    expect_watertight(mesh);
    const double bend = joints == Joints::kRound ? 0.04 * 2 * kPi * 2 * kReach : 0;
    EXPECT_NEAR(measure(mesh).volume, 0.04 * joined.curve.length(), 1e-6 + bend * 0.0114);
  }
  const JoinedTrajectory round = join(frame, Joints::kRound);
  for (std::size_t i = 0; i < round.curve.segments().size(); ++i) EXPECT_FALSE(round.curve.is_corner(i)) << i;
}

TEST(Joints, BetweenBentLegsStayTangent) {
  // Two quarter circles that meet at a right angle.
  const Curve3 path({ArcSegment<3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 180, 90},
                     ArcSegment<3>{{0, 2, 0}, {0, -1, 0}, {1, 0, 0}, 0, 90}});
  ASSERT_TRUE(path.is_corner(1) || glm::dot(path.tangent({0, 1}), path.tangent({1, 0})) > 0.99);
  const Curve3 wave({ArcSegment<3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 180, 90},
                     ArcSegment<3>{{0, 2, 0}, {0, -1, 0}, {-1, 0, 0}, 0, 90}});
  ASSERT_TRUE(wave.is_corner(1));
  EXPECT_THROW(join(wave, Joints::kRound), InputError) << "it turns right back";
  const Curve3 gable({ArcSegment<3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 180, 120},
                      ArcSegment<3>{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, 60, 0}});
  const JoinedTrajectory joined = join(gable, Joints::kRound);
  EXPECT_EQ(joined.curve.segments().size(), 3u);
  for (std::size_t i = 1; i < 3; ++i) EXPECT_FALSE(joined.curve.is_corner(i));
  expect_watertight(tube(gable, Joints::kRound));
  expect_watertight(tube(gable, Joints::kBevel));
}

TEST(Joints, LetVGoOnByArcLength) {
  for (const Joints joints : {Joints::kMiter, Joints::kRound, Joints::kBevel}) {
    const Mesh mesh = tube(elbow(90), joints, 64);
    const double length = join(elbow(90), joints).curve.length();
    // On the first leg v is the distance from its start.
    for (std::uint32_t i = 0; i < mesh.patches.front().vertex_count(); ++i) {
      const glm::dvec3 p = test::position(mesh, i);
      if (p.x < -1 && std::abs(p.z) < 0.1 - 1e-6) {
        // A ring near a mitre leans towards it, evenly over the leg.
        EXPECT_NEAR(mesh.texcoords()[i].y * length, 3 + p.x, 0.11) << p.x;
      }
    }
    // Patch by patch v goes on where it was.
    double at = 0;
    for (const GridPatch& patch : mesh.patches) {
      const double first = mesh.texcoords()[patch.vertex(0, 0)].y;
      const double last = mesh.texcoords()[patch.vertex(0, patch.rows)].y;
      EXPECT_LE(first, at + 1e-6);
      EXPECT_GT(last, first);
      at = std::max(at, last);
    }
    EXPECT_EQ(at, 1);
  }
}

TEST(Joints, SmoothOnesDoNotBreakTheNormals) {
  EXPECT_GT(tube(elbow(90), Joints::kMiter).patches.size(), tube(elbow(90), Joints::kSmooth).patches.size());
}

TEST(Joints, GrowWithTheProfile) {
  const Law law = Law::through({{0, 1}, {1, 3}});
  const SweepOptions options{.tessellation = {8, 64}, .joints = Joints::kRound, .profile = {law, law}};
  const Mesh mesh = sweep(kSquare, elbow(90), options);
  expect_watertight(mesh);
  // At the corner the profile is 2.
  const JoinedTrajectory joined = join(elbow(90), Joints::kRound, 4, 2 * kReach);
  EXPECT_NEAR(joined.curve.end_lengths()[0], 3 - 4 * kReach, 1e-12);
}

TEST(Joints, RefuseACornerThatTurnsRightBack) {
  const Curve3 back = polyline<3>({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, false);
  for (const Joints joints : {Joints::kMiter, Joints::kSmooth, Joints::kRound, Joints::kBevel}) {
    EXPECT_THROW(tube(back, joints), InputError);
  }
}

}  // namespace
}  // namespace sweepkit::sweep
