// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sweepkit/sweep/sweep.hpp"
#include "wall_distance.hpp"

namespace sweepkit::report {

/// A swept shape whose surface is also known by formulas that share nothing with the sweep.
struct TestShape {
  std::string name;
  std::string title;
  double size;  ///< metres, of the whole
  /// Cells along v for each along u, so that both directions are about as far off.
  double balance;
  std::function<sweep::Mesh(const sweep::Tessellation&)> make;
  /// Takes a mesh's counts of cells along u and v.
  std::function<sweep::Tessellation(int columns, int rows)> counts;
  SurfaceDistance distance;
};

/// A vase (a contour revolved, with a pole), a trefoil's tube (closed), a helix's tube (open), and a spindle
/// whose elliptical section turns and swells.
std::vector<TestShape> test_shapes();

}  // namespace sweepkit::report
