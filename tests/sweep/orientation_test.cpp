// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"

namespace sweepkit::sweep {
namespace {

constexpr double kPi = std::numbers::pi;

Curve3 hill() {
  return bezier_curve<3>({{0, 0, 0}, {1, 2, 0}, {3, -1, 2}, {4, 1, 1}});
}

std::vector<StationFrames> frames_of(const Curve3& curve, const Orientation& orientation, int cells,
                                     const Law& twist_deg = 0) {
  return orient(curve, place_stations(curve, cells), orientation, twist_deg, 1).frames;
}

// The rate that a frame tells is that of its N towards B. The difference of neighbours is of second order:
// `tolerance` is what 2,000 cells leave of it.
void expect_rates(const Curve3& curve, const Orientation& orientation, const Law& twist_deg,
                  double tolerance) {
  const std::vector<StationFrames> frames = frames_of(curve, orientation, 2000, twist_deg);
  const double step = curve.length() / 2000;
  for (std::size_t i = 1; i + 1 < frames.size(); ++i) {
    const glm::dvec3 change = (frames[i + 1].in.frame.normal - frames[i - 1].out.frame.normal) / (2 * step);
    EXPECT_NEAR(glm::dot(change, frames[i].in.frame.binormal), frames[i].in.rate, tolerance) << i;
  }
}

TEST(Orientation, TellsTheRateItTurnsAt) {
  const Curve3 guide = polyline<3>({{0, 3, 0}, {4, 3, 1}}, false);
  expect_rates(hill(), {}, 0, 1e-5);
  expect_rates(hill(), {}, Law::through({{0, 0}, {0.5, 200}, {1, 90}}), 2e-2);  // its slope bends at a point
  expect_rates(hill(), {.frames = Frames::kFixedUp}, 0, 1e-4);
  expect_rates(hill(), {.frames = Frames::kFrenet}, 0, 1e-3);
  expect_rates(hill(), {.guide = guide}, 0, 1e-4);
}

TEST(Orientation, FixedUpKeepsTheSectionLevel) {
  for (const StationFrames& station : frames_of(hill(), {.frames = Frames::kFixedUp}, 100)) {
    EXPECT_NEAR(station.in.frame.normal.y, 0, 1e-14);
    EXPECT_GT(station.in.frame.binormal.y, 0);
  }
}

TEST(Orientation, FixedUpGoesOnWhereTheCurveStandsUpright) {
  const Curve3 hook = polyline<3>({{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {5, 3, 0}}, false);
  const auto frames = frames_of(hook, {.frames = Frames::kFixedUp}, 12);
  EXPECT_NEAR(frames.front().out.frame.binormal.y, 1, 1e-14);
  EXPECT_NEAR(frames.back().in.frame.binormal.y, 1, 1e-14);
  for (const StationFrames& station : frames) EXPECT_NEAR(glm::length(station.out.frame.normal), 1, 1e-14);
}

TEST(Orientation, FrenetPointsAtTheCentreOfCurvature) {
  const Curve3 ring = circle_trajectory(2);
  for (const StationFrames& station : frames_of(ring, {.frames = Frames::kFrenet}, 40)) {
    const glm::dvec3 t = station.in.frame.tangent;
    EXPECT_LT(glm::length(station.in.frame.normal - glm::dvec3(t.z, 0, -t.x)), 1e-12)
        << "from a point of the circle, the tangent's left is the middle";
  }
}

TEST(Orientation, FrenetPassesAnInflectionWithoutAFlip) {
  const Curve3 wave = bezier_curve<3>({{0, 0, 0}, {2, 3, 0}, {1, -3, 0}, {3, 0, 0}});
  const auto frames = frames_of(wave, {.frames = Frames::kFrenet}, 200);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_GT(glm::dot(frames[i].in.frame.normal, frames[i - 1].out.frame.normal), 0.9) << i;
  }
}

TEST(Orientation, FrenetOfAStraightLineIsTheRotationMinimizingFrame) {
  const Curve3 line = polyline<3>({{0, 0, 0}, {1, 2, 3}}, false);
  const auto frenet = frames_of(line, {.frames = Frames::kFrenet}, 5);
  const auto plain = frames_of(line, {}, 5);
  for (std::size_t i = 0; i < plain.size(); ++i)
    EXPECT_EQ(frenet[i].in.frame.normal, plain[i].in.frame.normal);
}

TEST(Orientation, AGuideIsPointedAt) {
  const Curve3 guide = bezier_curve<3>({{0, 3, 0}, {2, 5, 1}, {4, 3, 2}});
  const Curve3 curve = hill();
  const auto stations = place_stations(curve, 50);
  const auto frames = orient(curve, stations, {.guide = guide}, 0, 1).frames;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double share = stations[i].length / curve.length();
    const glm::dvec3 to = guide.evaluate(guide.locate(share * guide.length())).position -
                          curve.evaluate(stations[i].in).position;
    const Frame& f = frames[i].in.frame;
    EXPECT_NEAR(glm::dot(to, f.binormal), 0, 1e-12);
    EXPECT_GT(glm::dot(to, f.normal), 0);
  }
}

TEST(Orientation, AGuideOnTheTrajectoryItselfChangesNothing) {
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 4}}, false);
  const auto frames = frames_of(line, {.guide = line}, 4);
  EXPECT_EQ(frames.back().in.frame.normal, frames.front().in.frame.normal);
}

TEST(Orientation, UpSaysWhereTheSectionStandsAtTheStart) {
  const Curve3 line = polyline<3>({{0, 0, 0}, {1, 0, 0}}, false);
  EXPECT_EQ(frames_of(line, {.up = {0, 0, 2}}, 1).front().out.frame.binormal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(frames_of(line, {.up = {5, 0, 0}}, 1).front().out.frame.binormal, glm::dvec3(0, 0, -1));
  EXPECT_THROW(frames_of(line, {.up = {0, 0, 0}}, 1), InputError);
}

TEST(Orientation, TwistTurnsRightHandedAboutTheTangent) {
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
  const auto frames = frames_of(line, {}, 4, Law::through({{0, 0}, {1, 90}}));
  EXPECT_LT(glm::length(frames.front().out.frame.normal - glm::dvec3(1, 0, 0)), 1e-15);
  EXPECT_LT(glm::length(frames.back().in.frame.normal - glm::dvec3(0, 1, 0)), 1e-15);
  EXPECT_NEAR(frames[2].in.rate, kPi / 2, 1e-15);
}

TEST(Orientation, ManyWholeTurnsComeHomeExactly) {
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
  const auto frames = frames_of(line, {}, 4, Law::through({{0, 0}, {1, 360e6}}));
  EXPECT_EQ(frames.back().in.frame.normal, frames.front().out.frame.normal);
}

TEST(Orientation, ClosesOnAClosedTrajectory) {
  const Curve3 curve = free_curve<3>({{1, 0, 0}, {0, 0.5, 1}, {-1, -0.5, 0.2}, {0, 0.3, -1}}, true);
  const auto frames = frames_of(curve, {}, 64);
  EXPECT_NE(frames[1].in.rate, 0);
  EXPECT_EQ(frames.front().out.frame.normal, frames.back().in.frame.normal);
  // The last step before the seam leads there: the frame turns no more in it than in its neighbours.
  const auto turn = [&](std::size_t i) {
    return glm::length(frames[i].in.frame.normal - frames[i - 1].out.frame.normal);
  };
  EXPECT_LT(turn(64), 2 * std::max(turn(63), turn(1)) + 1e-6);
}

TEST(Orientation, ClosesToTheNearestTurnOfTheSectionsSymmetry) {
  const Curve3 ring = circle_trajectory(1);
  const auto stations = place_stations(ring, 32);
  const Law twist = Law::through({{0, 0}, {1, 100}});
  for (const auto& [symmetry, steps, total_deg] :
       {std::tuple{1, 0, 0.0}, {2, 1, 180.0}, {4, 1, 90.0}, {36, 10, 100.0}}) {
    const Oriented oriented = orient(ring, stations, {}, twist, symmetry);
    EXPECT_EQ(oriented.closing_steps, steps) << symmetry;
    EXPECT_NEAR(oriented.frames[16].in.rate, total_deg * kPi / 180 / ring.length(), 1e-12) << symmetry;
  }
}

}  // namespace
}  // namespace sweepkit::sweep
