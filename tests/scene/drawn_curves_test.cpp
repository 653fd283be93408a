// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/drawn_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_text.hpp"

namespace sweepkit::scene {
namespace {

std::vector<DrawnCurve> curves_of(const std::string& object) {
  return drawn_curves(parse(scene_text("", object)).objects.front());
}

TEST(DrawnCurves, OfASweepAreTheTrajectoryAndTheContourAtItsStart) {
  // Along +Z, halved at the start and turned by a quarter: B is `up`, N = B x T.
  const auto curves = curves_of(R"({"name": "a", "translate": [5, 0, 0], "sweep": {
    "contour": {"polyline": [[0, 0], [0.4, 0]]}, "trajectory": {"line": [[0, 0, 1], [0, 0, 3]]},
    "profile": {"points": [[0, 0.5], [1, 1]]}, "twist_deg": {"points": [[0, 90], [1, 90]]}}})");
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].kind, DrawnCurve::Kind::kTrajectory);
  EXPECT_EQ(curves[0].points, (std::vector<glm::dvec3>{{5, 0, 1}, {5, 0, 3}}));
  EXPECT_EQ(curves[1].kind, DrawnCurve::Kind::kContour);
  // Float32 vertices.
  EXPECT_NEAR(glm::length(curves[1].points.front() - glm::dvec3(5, 0, 1)), 0, 1e-6);
  EXPECT_NEAR(glm::length(curves[1].points.back() - glm::dvec3(5, 0.2, 1)), 0, 1e-6);
}

TEST(DrawnCurves, OfARevolveAreTheContourAndTheAxis) {
  const auto curves = curves_of(
      R"({"name": "a", "revolve": {"contour": {"polyline": [[1, 2], [3, 4]]}}, "instances": [{}, {"translate": [0, 9, 0]}]})");
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(curves[0].kind, DrawnCurve::Kind::kContour);
  EXPECT_EQ(curves[0].points, (std::vector<glm::dvec3>{{1, 2, 0}, {3, 4, 0}}));
  EXPECT_EQ(curves[1].kind, DrawnCurve::Kind::kAxis);
  EXPECT_EQ(curves[1].points, (std::vector<glm::dvec3>{{0, 2, 0}, {0, 4, 0}}));
  EXPECT_EQ(curves[2].kind, DrawnCurve::Kind::kContour);
  EXPECT_EQ(curves[2].points.front(), glm::dvec3(1, 11, 0));
}

TEST(DrawnCurves, AreNearTheCurvesBetweenTheirPoints) {
  const auto curves = curves_of(
      R"({"name": "a", "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"circle": {"radius": 2}}}})");
  ASSERT_EQ(curves.size(), 2u);
  const std::vector<glm::dvec3>& points = curves[0].points;
  EXPECT_EQ(points.front(), points.back());
  for (std::size_t i = 1; i < points.size(); ++i) {
    // A chord of 5 degrees is 1 - cos 2.5 degrees of the radius from its arc.
    EXPECT_NEAR(glm::length(0.5 * (points[i] + points[i - 1])), 2,
                2 * (1 - std::cos(2.5 * M_PI / 180)) + 1e-12);
  }
  const std::vector<glm::dvec3>& contour = curves[1].points;
  EXPECT_EQ(contour.front(), contour.back());
}

TEST(DrawnCurves, HolesAndCornersAreThere) {
  const auto curves =
      curves_of(R"({"name": "a", "sweep": {"trajectory": {"polyline": [[0, 0, 0], [0, 2, 0], [2, 2, 0]]},
    "contour": {"path": "M-.5-.5H.5V.5H-.5zM-.2-.2V.2H.2V-.2z"}}})");
  std::size_t contours = 0;
  for (const DrawnCurve& curve : curves) {
    if (curve.kind != DrawnCurve::Kind::kContour) continue;
    ++contours;
    for (const glm::dvec3& p : curve.points) EXPECT_NEAR(p.y, 0, 1e-6);
  }
  EXPECT_GE(contours, 2u);
}

TEST(DrawnCurves, OfAPlaneAreNone) {
  EXPECT_TRUE(curves_of(R"({"name": "a", "plane": {"size": [1, 1]}})").empty());
}

}  // namespace
}  // namespace sweepkit::scene
