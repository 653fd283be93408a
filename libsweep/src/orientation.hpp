// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "frames.hpp"
#include "stations.hpp"
#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/law.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// How the section stands at every station of a trajectory, twist and closing included.
struct Oriented {
  std::vector<StationFrames> frames;
  /// A closed trajectory comes home turned by this many steps of the section's symmetry; the frame it comes
  /// home in is the first one's, those steps taken off.
  int closing_steps = 0;
};

/// `symmetry`: turned by a whole turn / symmetry the section covers itself (1 for none). A closed
/// trajectory's leftover angle is spread along it by arc length, to the nearest turn that the symmetry
/// allows. Throws InputError for an `up` that is no direction.
Oriented orient(const Curve3& trajectory, std::span<const Station> stations, const Orientation& orientation,
                const Law& twist_deg, int symmetry);

}  // namespace sweepkit::sweep
