// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "whole_angle.hpp"

namespace sweepkit::sweep {
namespace {

// Places this near to each other, as a share of the contour's size, are the same: arcs and hand-typed
// coordinates are less exact than double, and float32 shows no less.
constexpr double kSame = 1e-7;

}  // namespace

int symmetry_of(const Section& section) {
  if (!section.is_closed) return 1;
  const auto count = static_cast<int>(section.points.size()) - 1;
  const double reach = reach_of(section);
  const auto is_onto_itself = [&](int turns) {
    const auto [c, s] = cos_sin_turn(1, turns);
    for (int i = 0; i < count; ++i) {
      const auto from = static_cast<std::size_t>(i);
      const auto to = static_cast<std::size_t>((i + count / turns) % count);
      const glm::dvec2 p = section.points[from].position;
      const glm::dvec2 turned(c * p.x - s * p.y, s * p.x + c * p.y);
      if (glm::length(section.points[to].position - turned) > kSame * reach) return false;
      if (section.breaks[to] != section.breaks[from]) return false;
    }
    return true;
  };
  for (int turns = count; turns > 1; --turns) {
    if (count % turns == 0 && is_onto_itself(turns)) return turns;
  }
  return 1;
}

int symmetry_of(const Curve2& contour, int most) {
  // Places in a turn: enough for a contour of many corners.
  constexpr int kPlaces = 64;
  if (!contour.is_closed()) return 1;
  for (int turns = most; turns > 1; --turns) {
    std::vector<glm::dvec2> places(static_cast<std::size_t>(kPlaces) * static_cast<std::size_t>(turns));
    double reach = 0;
    double twice_area = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(places.size());
      places[i] = contour.evaluate(contour.locate(contour.length() * share)).position;
      reach = std::max(reach, glm::length(places[i]));
      if (i > 0) twice_area += places[i - 1].x * places[i].y - places[i - 1].y * places[i].x;
    }
    const auto [c, s] = cos_sin_turn(twice_area < 0 ? -1 : 1, turns);
    bool is_onto_itself = true;
    for (std::size_t i = 0; i < places.size() && is_onto_itself; ++i) {
      const glm::dvec2& p = places[i];
      const glm::dvec2 turned(c * p.x - s * p.y, s * p.x + c * p.y);
      const glm::dvec2& there = places[(i + kPlaces) % places.size()];
      is_onto_itself = glm::length(there - turned) <= kSame * reach;
    }
    if (is_onto_itself) return turns;
  }
  return 1;
}

}  // namespace sweepkit::sweep
