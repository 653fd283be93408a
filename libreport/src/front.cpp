// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "front.hpp"

#include <algorithm>
#include <cmath>

namespace sweepkit::report {

std::vector<PlotPoint> front_of(std::vector<PlotPoint> points) {
  std::erase_if(points,
                [](const PlotPoint& point) { return !std::isfinite(point.x) || !std::isfinite(point.y); });
  std::sort(points.begin(), points.end(),
            [](const PlotPoint& a, const PlotPoint& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<PlotPoint> front;
  for (const PlotPoint& point : points) {
    if (front.empty() || point.y < front.back().y) front.push_back(point);
  }
  return front;
}

}  // namespace sweepkit::report
