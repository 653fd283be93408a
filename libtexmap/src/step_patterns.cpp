// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Patterns of steps along one axis, or products of such: their mean under a tent or a box along the axes is
// known.

#include <numeric>

#include "pattern.hpp"
#include "tent_steps.hpp"

namespace sweepkit::texmap {

glm::dvec3 checker(const Pattern& pattern, const PatternPlace& place) {
  const glm::dvec3 half = place.half_widths();
  double sign = 1;
  for (glm::length_t axis = 0; axis < 3; ++axis)
    sign *= 2 * filtered_pulse(place.at[axis], 0, 0.5, half[axis], place.shape) - 1;
  const double share = 0.5 + 0.5 * sign;
  return share * glm::dvec3(pattern.colors[0]) + (1 - share) * glm::dvec3(pattern.colors[1]);
}

glm::dvec3 bands(const Pattern& pattern, const PatternPlace& place) {
  const Colors colors = pattern.colors;
  const std::vector<double>& widths = pattern.given.widths;
  const bool is_even = widths.size() != colors.size();
  const double whole =
      is_even ? static_cast<double>(colors.size()) : std::accumulate(widths.begin(), widths.end(), 0.0);
  const double half = place.half_widths().y;
  glm::dvec3 sum(0.0);
  double from = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const bool is_last = i + 1 == colors.size();
    const double to = is_last ? 1 : std::min(1.0, from + (is_even ? 1.0 : widths[i]) / whole);
    sum += filtered_pulse(place.at.y, from, to, half, place.shape) * glm::dvec3(colors[i]);
    from = to;
  }
  return sum;
}

double narrowest_band(const Pattern& pattern) {
  const std::vector<double>& widths = pattern.given.widths;
  if (widths.size() != pattern.colors.size()) return 1.0 / static_cast<double>(pattern.colors.size());
  double narrowest = 1;
  const double whole = std::accumulate(widths.begin(), widths.end(), 0.0);
  for (const double width : widths) {
    if (width > 0) narrowest = std::min(narrowest, width / whole);
  }
  return narrowest;
}

}  // namespace sweepkit::texmap
