// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep::test {

struct Case {
  const char* name;
  Curve2 contour;
  Curve3 trajectory;
  SweepOptions options;
  double size;  // metres, of the whole
};

inline std::vector<Case> cases() {
  const Law spindle = Law::through({{0, 0}, {0.5, 1}, {1, 0}});
  const Law turn = Law::through({{0, 0}, {1, 180}});
  const Curve3 straight = polyline<3>({{0, 0, 0}, {0, 0, 3}}, false);
  const Curve3 bow = bezier_curve<3>({{0, 0, 0}, {1, 3, 0}, {3, 4, 2}, {5, 3, 6}});
  return {
      {"cylinder", circle_contour(1), straight, {}, 3},
      {"torus", circle_contour(0.3), circle_trajectory(1), {}, 2.6},
      {"knot", circle_contour(0.15), torus_knot(2, 3, 1, 0.4), {}, 3},
      {"twisted bow", rectangle_contour(0.3, 0.2, 0.05), bow, {.twist_deg = turn}, 8},
      {"Moebius band", rectangle_contour(1, 0.1), circle_trajectory(1), {.twist_deg = turn}, 3},
      {"pipe",
       circle_contour(0.1),
       polyline<3>({{0, 0, 0}, {0, 0, 3}, {0, 2, 3}}, false),
       {.joints = Joints::kRound},
       3.5},
      {"mitre",
       rectangle_contour(0.2, 0.1),
       polyline<3>({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, true),
       {},
       2},
      {"spindle", circle_contour(0.3), straight, {.profile = {spindle, spindle}}, 3},
      {"morph",
       star_contour(5, 0.5, 0.2),
       straight,
       {.morph = {{0.5, {circle_contour(0.4)}}, {1, {rectangle_contour(0.5, 0.3)}}}},
       3},
      {"drawn backwards", bezier_curve<2>({{0, 0}, {0, 1}, {3, 1}, {1, -1}, {0, 0}}), bow, {}, 8},
  };
}

inline Mesh fitted(const Case& c, double tolerance) {
  SweepOptions options = c.options;
  options.tessellation.tolerance = tolerance;
  return sweep(c.contour, c.trajectory, options);
}

inline Mesh counted(const Case& c, int columns, int rows) {
  SweepOptions options = c.options;
  options.tessellation = {columns, rows};
  options.has_half_edges = false;
  return sweep(c.contour, c.trajectory, options);
}

}  // namespace sweepkit::sweep::test
