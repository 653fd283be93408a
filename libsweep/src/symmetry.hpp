// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "section.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

/// The largest number of turns in a circle that bring a closed section onto itself, vertex by vertex: k turns
/// of a k-th of a circle, each moving every vertex on by points / k places. 1 for one without symmetry.
int symmetry_of(const Section& section);

/// The largest number of turns in a circle, `most` or less, that bring a closed contour onto itself as far as
/// many places all round it tell.
int symmetry_of(const Curve2& contour, int most);

}  // namespace sweepkit::sweep
