// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sweepkit/report/experiment.hpp"
#include "sweepkit/sweep/curve.hpp"
#include "test_curves.hpp"

namespace sweepkit::report {

/// A trajectory of any kind, by the sum of its segments' parameters. Its exact normals come from
/// Runge-Kutta's method in 16 times finer steps than asked for, and in 65,536 at least, none across a joint
/// of segments. Precondition: it has no corner.
TestCurve curve_of(std::string name, std::string title, sweep::Curve3 trajectory);

/// The trajectories of three samples, or those of the scene in their place, that leave a plane and have no
/// corner.
std::vector<TestCurve> sample_curves(const Effort& effort);

}  // namespace sweepkit::report
