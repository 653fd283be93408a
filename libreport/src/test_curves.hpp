// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::report {

/// A curve whose rotation-minimizing frame is known: Frenet's frame turned back by the integral of the
/// torsion, all in quadruple precision.
struct TestCurve {
  std::string name;   ///< "H"
  std::string title;  ///< what it is
  double from = 0;
  double to = 1;
  std::function<sweep::CurvePoint<3>(double u)> evaluate;
  /// Normals of the frame that is Frenet's at the start, at `steps` + 1 even parameters.
  std::function<std::vector<glm::dvec3>(int steps)> normals;
};

/// H a helix, K a knot on a torus, B a cubic Bezier segment: those of the frames' literature.
std::vector<TestCurve> test_curves();

}  // namespace sweepkit::report
