// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "object_reader.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::scene {

/// CURVE of the scene format, as a contour or as a trajectory.
sweep::Curve2 read_contour(const Node& node);
sweep::Curve3 read_trajectory(const Node& node);

}  // namespace sweepkit::scene
