// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

/// Plane segments with those Bezier segments cut in two that come to rest on their way: at a cusp the
/// direction jumps, and between segments it may. Others stay as they are, to the bit.
std::vector<Segment<2>> split_at_cusps(std::vector<Segment<2>> segments);

}  // namespace sweepkit::sweep
