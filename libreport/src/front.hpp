// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace sweepkit::report {

struct PlotPoint {
  double x = 0;
  double y = 0;
};

/// The points that none other is both lower in x and lower in y than (Pareto's front), by rising x. Those
/// that are not finite take no part.
std::vector<PlotPoint> front_of(std::vector<PlotPoint> points);

}  // namespace sweepkit::report
