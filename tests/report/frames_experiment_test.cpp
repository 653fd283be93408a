// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "frames_experiment.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace sweepkit::report {
namespace {

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
  const Experiment experiment = measure_frames({.is_quick = true, .samples = SWEEPKIT_SAMPLES});
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
