// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "frame_methods.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "frames_experiment.hpp"
#include "test_curves.hpp"

namespace sweepkit::report {
namespace {

TEST(TestCurves, ExactNormalsAreUnitPerpendicularAndTurnAboutTheTangentNotAtAll) {
  for (const TestCurve& curve : test_curves()) {
    constexpr int kSteps = 4096;
    const std::vector<glm::dvec3> normals = curve.normals(kSteps);
    ASSERT_EQ(normals.size(), kSteps + 1u);
    const double step = (curve.to - curve.from) / kSteps;
    for (int i = 0; i <= kSteps; i += 64) {
      const sweep::CurvePoint<3> point = curve.evaluate(curve.from + step * i);
      const glm::dvec3 tangent = glm::normalize(point.first);
      const glm::dvec3& r = normals[static_cast<std::size_t>(i)];
      EXPECT_NEAR(glm::length(r), 1, 1e-15);
      // The tangent is in double: K's angle 7u, up to 44, is rounded by 3.6e-15.
      EXPECT_NEAR(glm::dot(r, tangent), 0, 1e-14) << curve.name;
      if (i == 0 || i == kSteps) continue;
      // r' has no part along T x r; the central difference errs by step^2 / 6 of the third derivative, which
      // these curves keep below 1e4.
      const glm::dvec3 slope =
          (normals[static_cast<std::size_t>(i) + 1] - normals[static_cast<std::size_t>(i) - 1]) / (2 * step);
      EXPECT_NEAR(glm::dot(slope, glm::cross(tangent, r)), 0, 1e4 * step * step) << curve.name;
    }
  }
}

// The figures of the literature's curves, measured elsewhere; a tenth of each is allowed. (Runge-Kutta's on B
// depends on where the first normal points, which is not told there.)
TEST(FramesExperiment, AgreesWithFiguresMeasuredElsewhere) {
  const std::map<std::tuple<std::string, double, std::string>, double> figures = {
      {{"H", 64, "chord projection"}, 7.861e-3},    {{"H", 64, "rotation"}, 1.448e-2},
      {{"H", 64, "double reflection"}, 1.857e-6},   {{"H", 64, "Runge-Kutta 4"}, 7.295e-5},
      {{"H", 256, "chord projection"}, 4.904e-4},   {{"H", 256, "rotation"}, 9.029e-4},
      {{"H", 256, "double reflection"}, 7.255e-9},  {{"H", 256, "Runge-Kutta 4"}, 2.875e-7},
      {{"K", 256, "chord projection"}, 2.263e-2},   {{"K", 256, "rotation"}, 4.758e-2},
      {{"K", 256, "double reflection"}, 2.034e-5},  {{"K", 256, "Runge-Kutta 4"}, 1.733e-4},
      {{"K", 1024, "chord projection"}, 1.414e-3},  {{"K", 1024, "rotation"}, 2.969e-3},
      {{"K", 1024, "double reflection"}, 7.955e-8}, {{"K", 1024, "Runge-Kutta 4"}, 6.803e-7},
      {{"B", 64, "chord projection"}, 1.606e-4},    {{"B", 64, "rotation"}, 1.347e-4},
      {{"B", 64, "double reflection"}, 2.270e-8}};
  const Experiment experiment = measure_frames({.is_quick = true});
  const Table& table = experiment.table;
  std::size_t found = 0;
  for (const std::vector<Cell>& row : table.rows) {
    const auto text = [&](const char* name) { return std::get<std::string>(row[table.column(name)]); };
    const auto number = [&](const char* name) { return std::get<double>(row[table.column(name)]); };
    const auto figure = figures.find({text("curve"), number("steps"), text("method")});
    if (figure == figures.end()) continue;
    ++found;
    EXPECT_NEAR(number("radians"), figure->second, 0.1 * figure->second)
        << text("curve") << " " << text("method");
  }
  EXPECT_EQ(found, figures.size());
}

}  // namespace
}  // namespace sweepkit::report
