// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sample_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene_files.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/sweep/primitives.hpp"

namespace sweepkit::report {
namespace {

constexpr int kSteps = 12;

// Of a helix (r cos a, b a, -r sin a): Frenet's normal points to the axis, and the rotation-minimizing frame
// turns back against it by the torsion b / (r^2 + b^2) times the length sqrt(r^2 + b^2) a.
TEST(SampleCurves, NormalsOfAHelixAreItsClosedForm) {
  const double radius = 0.5;
  const double rise = 0.2 / (2 * std::numbers::pi);
  const TestCurve curve = curve_of("helix", "", sweep::helix(radius, 0.2, 3));
  const std::vector<glm::dvec3> normals = curve.normals(kSteps);
  ASSERT_EQ(normals.size(), kSteps + 1u);
  double first = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const sweep::CurvePoint<3> point = curve.evaluate(curve.from + (curve.to - curve.from) * i / kSteps);
    const glm::dvec3 tangent = glm::normalize(point.first);
    const glm::dvec3 inwards = glm::normalize(glm::dvec3(-point.position.x, 0, -point.position.z));
    const glm::dvec3 binormal = glm::cross(tangent, inwards);
    const glm::dvec3& normal = normals[static_cast<std::size_t>(i)];
    const double angle = std::atan2(glm::dot(normal, binormal), glm::dot(normal, inwards));
    if (i == 0) first = angle;
    const double turned = 3 * 2 * std::numbers::pi * i / kSteps * rise / std::hypot(radius, rise);
    // 65,536 steps of Runge-Kutta's method: (2 pi 3 / 65,536)^4 is 7e-15, and as many roundings of 1e-16
    // wander by sqrt(65,536) of them, 3e-14.
    EXPECT_NEAR(std::remainder(angle - first + turned, 2 * std::numbers::pi), 0, 2e-13) << i;
  }
}

TEST(SampleCurves, NormalsAcrossAJointStayPerpendicularAndUnit) {
  const sweep::Curve3 trajectory =
      sweep::free_curve<3>({{0, 0, 0}, {1, 0.2, 0}, {1.2, 1, 0.5}, {0.3, 1.4, 1}, {0, 2, 0}}, false);
  const TestCurve curve = curve_of("free", "", trajectory);
  EXPECT_EQ(curve.to, static_cast<double>(trajectory.segments().size()));
  const std::vector<glm::dvec3> normals = curve.normals(kSteps);
  for (int i = 0; i <= kSteps; ++i) {
    const sweep::CurvePoint<3> point = curve.evaluate(curve.to * i / kSteps);
    const glm::dvec3& normal = normals[static_cast<std::size_t>(i)];
    // As above; nothing makes the normals perpendicular again.
    EXPECT_NEAR(glm::dot(normal, glm::normalize(point.first)), 0, 1e-12) << i;
    EXPECT_NEAR(glm::length(normal), 1, 1e-12) << i;
  }
}

TEST(SampleCurves, AreTheTrajectoriesThatLeaveAPlaneAndHaveNoCorner) {
  std::vector<std::string> names;
  for (const TestCurve& curve : sample_curves({.samples = SWEEPKIT_SAMPLES})) names.push_back(curve.name);
  EXPECT_EQ(names, (std::vector<std::string>{"spring", "shell", "knot"}));
  EXPECT_TRUE(sample_curves({.scene = SWEEPKIT_SAMPLES "/scenes/pipe_run.json"}).empty());
}

TEST(SampleCurves, AreThoseOfAGivenSceneInPlaceOfTheSamples) {
  const std::vector<TestCurve> curves =
      sample_curves({.samples = "nowhere", .scene = SWEEPKIT_SAMPLES "/scenes/knot_on_column.json"});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].title, "trajectory in knot_on_column.json");
}

TEST(SceneFiles, AFileNameHasLettersDigitsAndUnderscoresAlone) {
  EXPECT_EQ(file_name("left wall/1.2"), "left_wall_1_2");
}

}  // namespace
}  // namespace sweepkit::report
