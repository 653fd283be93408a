// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace sweepkit::report {

/// A way to evaluate a Bezier segment of degree up to 63 at parameters in [0, 1].
struct BezierMethod {
  std::string name;
  void (*evaluate)(std::span<const glm::dvec3> control, std::span<const double> t,
                   std::span<glm::dvec3> points);
};

/// De Casteljau, which libsweep takes; Horner's rule on the Bernstein form; compensated de Casteljau;
/// Horner's rule on powers of t.
std::vector<BezierMethod> bezier_methods();

}  // namespace sweepkit::report
