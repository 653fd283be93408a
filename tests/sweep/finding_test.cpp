// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/finding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "outline_crossing.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Finding> check(const Curve2& contour, const Curve3& trajectory,
                           const SweepOptions& options = {}) {
  return check_sweep(std::span(&contour, 1), trajectory, options);
}

Curve3 lemniscate() {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 48; ++i) {
    const double a = 2 * kPi * i / 48;
    points.emplace_back(std::cos(a), 0, std::sin(a) * std::cos(a));
  }
  return free_curve<3>(points, true);
}

TEST(Finding, AContourLargerThanTheRadiusOfCurvatureFolds) {
  const std::vector<Finding> findings = check(circle_contour(0.11), circle_trajectory(0.1));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kFold);
  // 96 columns have one on the circle's inner side; the frame's rates carry no error worth a name.
  EXPECT_NEAR(findings[0].severity, 1.1, 1e-9);
  EXPECT_EQ(findings[0].from, 0);
  EXPECT_EQ(findings[0].to, 1);
  EXPECT_EQ(findings[0].cure, "the contour fits when made 0.909 times as large");
  EXPECT_NEAR(glm::length(findings[0].point), 0.01, 1e-9);
}

TEST(Finding, AContourMadeAsLargeAsTheCureSaysDoesNotFold) {
  const Curve3 bend = bezier_curve<3>({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1.2}});
  const std::vector<Finding> findings = check(circle_contour(0.6), bend);
  ASSERT_EQ(findings.size(), 1u);
  const double factor = 1 / findings[0].severity;
  EXPECT_TRUE(check(circle_contour(0.6 * factor * 0.999), bend).empty());
  EXPECT_EQ(check(circle_contour(0.6 * factor * 1.01), bend).size(), 1u);
  EXPECT_GT(findings[0].from, 0);
  EXPECT_LT(findings[0].to, 1);
}

TEST(Finding, AProfileThatShrinksInTheBendKeepsItFromFolding) {
  const Law law = Law::through({{0, 1}, {0.5, 0.4}, {1, 1}});
  const Curve3 bend = bezier_curve<3>({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}});
  EXPECT_EQ(check(circle_contour(0.5), bend).size(), 1u);
  EXPECT_TRUE(check(circle_contour(0.5), bend, {.profile = {law, law}}).empty());
}

TEST(Finding, SoundSweepsHaveNone) {
  EXPECT_TRUE(check(circle_contour(0.3), circle_trajectory(1)).empty());
  EXPECT_TRUE(check(circle_contour(0.15), torus_knot(2, 3, 1, 0.4)).empty());
  EXPECT_TRUE(check(star_contour(5, 0.2, 0.1), helix(1, 0.5, 3)).empty());
  const Curve3 corner = polyline<3>({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, false);
  for (const Joints joints : {Joints::kMiter, Joints::kRound, Joints::kBevel, Joints::kSmooth})
    EXPECT_TRUE(check(circle_contour(0.1), corner, {.joints = joints}).empty());
}

TEST(Finding, ALegTooShortForItsMitresFolds) {
  const Curve3 step = polyline<3>({{0, 0, 0}, {1, 0, 0}, {1, 0, 0.1}, {0, 0, 0.1}}, false);
  const std::vector<Finding> findings = check(circle_contour(0.2), step);
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].kind, FindingKind::kFold);
}

TEST(Finding, SoundMeshesDoNotCross) {
  const Law turn = Law::through({{0, 0}, {1, 180}});
  for (const Mesh& mesh : {sweep(circle_contour(0.3), circle_trajectory(1)),
                           sweep(circle_contour(0.15), torus_knot(2, 3, 1, 0.4)),
                           sweep(rectangle_contour(0.5, 0.05), circle_trajectory(1), {.twist_deg = turn}),
                           sweep(star_contour(9, 0.2, 0.1), helix(1, 0.5, 3), {.caps = Caps::kFlat}),
                           sweep(circle_contour(0.2), helix(1, 0.5, 3), {.caps = Caps::kRound}),
                           revolve(bezier_curve<2>({{0, 0}, {1, 0}, {0.2, 1.5}, {0, 2}}))}) {
    EXPECT_TRUE(find_crossings(mesh).empty());
  }
}

TEST(Finding, AFigureOfEightCrossesInItsMiddle) {
  const Mesh mesh = sweep(circle_contour(0.05), lemniscate(), {.tessellation = {24, 400}});
  const std::vector<Finding> findings = find_crossings(mesh);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kCrossing);
  // The tubes, 0.1 m wide, meet at right angles in the middle of a curve of 6.1 m.
  EXPECT_NEAR(findings[0].t, 0.25, 0.02);
  EXPECT_NEAR(*findings[0].other, 0.75, 0.02);
  EXPECT_LT(glm::length(findings[0].point), 0.15);
  EXPECT_GT(findings[0].severity, 0);
}

TEST(Finding, TheTurnsOfATightHelixCross) {
  const auto crossings = [](double pitch) {
    return find_crossings(sweep(circle_contour(0.1), helix(1, pitch, 3), {.tessellation = {32, 300}}));
  };
  EXPECT_TRUE(crossings(0.21).empty());
  const std::vector<Finding> findings = crossings(0.17);
  ASSERT_FALSE(findings.empty());
  // One turn on.
  EXPECT_NEAR(*findings[0].other - findings[0].t, 1.0 / 3, 0.01);
}

TEST(Finding, AContourThatGoesThroughItselfIsFound) {
  const Curve2 bow_tie = polyline<2>({{0, 0}, {1, 1}, {1, 0}, {0, 0.8}}, true);
  const std::vector<Finding> findings = check(bow_tie, polyline<3>({{0, 0, 0}, {0, 0, 3}}, false));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kContourCrossing);
  // y = x meets y = 0.8 (1 - x).
  EXPECT_NEAR(findings[0].point.x, 0.8 / 1.8, 1e-12);
  EXPECT_NEAR(findings[0].point.y, 0.8 / 1.8, 1e-12);
}

TEST(Finding, AMorphThatFoldsOnItsWayIsFoundBetweenItsContours) {
  // A horseshoe that opens to the right and its mirror image: every point goes straight across.
  const auto horseshoe = [](double side) {
    return polyline<2>({{side * 1, 0.9},
                        {side * -1, 0.9},
                        {side * -1, -0.9},
                        {side * 1, -0.9},
                        {side * 1, -0.7},
                        {side * -0.8, -0.7},
                        {side * -0.8, 0.7},
                        {side * 1, 0.7}},
                       true);
  };
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 3}}, false);
  SweepOptions options;
  options.morph.push_back({0.5, {horseshoe(-1)}});
  options.morph.push_back({1, {horseshoe(-1)}});
  const std::vector<Finding> findings = check(horseshoe(1), line, options);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kFoldedMorph);
  EXPECT_GT(findings[0].from, 0);
  EXPECT_LT(findings[0].to, 0.5);
  EXPECT_NEAR(findings[0].point.z, 3 * findings[0].t, 0.01);
  // A circle between them keeps it from folding.
  options.morph.insert(options.morph.begin(), {0.25, {circle_contour(1)}});
  EXPECT_TRUE(check(horseshoe(1), line, options).empty());
  // A star that becomes a circle does not.
  EXPECT_TRUE(check(star_contour(5, 1, 0.4), line, {.morph = {{1, {circle_contour(1)}}}}).empty());
}

TEST(Finding, DirectionsThatTellNothingAreFound) {
  const Curve3 up = polyline<3>({{0, 0, 0}, {0, 3, 0}}, false);
  const auto kind = [&](const Orientation& orientation) {
    const std::vector<Finding> findings = check(circle_contour(0.1), up, {.orientation = orientation});
    return findings.empty() ? std::string("none") : name_of(findings[0].kind);
  };
  EXPECT_EQ(kind({.frames = Frames::kFixedUp}), "no direction");
  EXPECT_EQ(kind({.frames = Frames::kFixedUp, .up = {1, 0, 0}}), "none");
  EXPECT_EQ(kind({.frames = Frames::kFrenet}), "no direction");
  EXPECT_EQ(kind({.guide = polyline<3>({{0, 1, 0}, {0, 4, 0}}, false)}), "no direction");
  EXPECT_EQ(kind({.guide = polyline<3>({{1, 0, 0}, {1, 3, 0}}, false)}), "none");
}

TEST(Finding, ACuspIsFound) {
  // x' = 3 (1 - 2 t)^2 - ... : the control polygon of a cubic with a cusp at its middle.
  const Curve3 cusp = bezier_curve<3>({{0, 0, 0}, {1, 0, 1}, {0, 0, 1}, {1, 0, 0}});
  const std::vector<Finding> findings = check(circle_contour(1e-4), cusp);
  ASSERT_FALSE(findings.empty());
  bool has_cusp = false;
  for (const Finding& finding : findings) {
    has_cusp = has_cusp || (finding.kind == FindingKind::kCusp && std::abs(finding.t - 0.5) < 0.01);
  }
  EXPECT_TRUE(has_cusp);
}

TEST(Finding, CoordinatesThatFloat32LosesAreFound) {
  const auto findings_at = [](double x) {
    return check(circle_contour(0.1), polyline<3>({{x, 0, 0}, {x, 0, 1}}, false));
  };
  EXPECT_TRUE(findings_at(1000).empty());
  ASSERT_EQ(findings_at(1e7).size(), 1u);
  EXPECT_EQ(findings_at(1e7)[0].kind, FindingKind::kPrecision);
  EXPECT_NEAR(findings_at(1e7)[0].severity, 1e7 / (1 << 24), 1e-6);
}

TEST(Finding, ManySidesAreHeldAgainstEachOtherInTime) {
  std::vector<glm::dvec2> points;
  constexpr int kPoints = 100000;
  for (int i = 0; i < kPoints; ++i) {
    const double a = 2 * kPi * i / kPoints;
    const double r = 1 + 0.1 * std::cos(40 * a);
    points.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  EXPECT_FALSE(find_crossing(points, true));
  std::swap(points[777], points[779]);
  EXPECT_TRUE(find_crossing(points, true));
}

}  // namespace
}  // namespace sweepkit::sweep
