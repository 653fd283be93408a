// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace sweepkit::bench {

struct PlotPoint {
  std::string label;
  double seconds;
  double error;
};

struct PlotCurve {
  std::string name;
  std::string color;
  bool is_joined = true;  ///< by a line from point to point
  std::vector<PlotPoint> points;
};

/// Error against time, both logarithmic, as an SVG picture.
std::string error_plot(const std::string& title, const std::vector<PlotCurve>& curves);

}  // namespace sweepkit::bench
