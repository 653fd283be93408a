// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::report {

/// A way to carry a normal along a curve in N even steps of its parameter. Positions and tangents are given;
/// what else it needs of the curve it asks for, and pays for.
struct FrameMethod {
  std::string name;
  /// Fills `normals`, whose first is given. `points` are at even parameters `step` apart.
  std::function<void(std::span<const sweep::CurvePoint<3>> points, double from, double step,
                     const std::function<sweep::CurvePoint<3>(double)>& evaluate,
                     std::span<glm::dvec3> normals)>
      carry;
};

/// Projection along the chord and rotation, of second order; double reflection, which libsweep takes, and
/// Runge-Kutta, of fourth.
std::vector<FrameMethod> frame_methods();

}  // namespace sweepkit::report
