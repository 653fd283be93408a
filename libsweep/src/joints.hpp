// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// A trajectory whose corners are joined: what is mitred is still a corner, a bevel's chord has one at each
/// end, a round joint has none.
struct JoinedTrajectory {
  Curve3 curve;
  std::vector<int>
      least_cells;  ///< a segment: so many cells at least show its bend; 1 for the trajectory's own
};

/// Cuts the corners that are to be round or bevelled, and those too sharp for a mitre. `reach(length)`: how
/// far the section reaches from the trajectory there. A joint is as wide as it takes for the section's inner
/// side not to fold, or as wide as the legs allow if they are shorter: at most half of a leg between two
/// corners. Throws InputError where a corner that is to be cut turns right back.
JoinedTrajectory join_corners(const Curve3& trajectory, Joints joints, double miter_limit,
                              const std::function<double(double length)>& reach);

}  // namespace sweepkit::sweep
