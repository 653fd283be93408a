// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/texmap/image.hpp"

namespace sweepkit::bench {

/// Twice the same chequered wall of cells, each cut along its diagonal, in float32 and looked at head on, so
/// that in every row of a cell one pixel's middle lies on the diagonal: mapped by the paper's cevian ratios
/// on the left, by the default on the right.
texmap::Image draw_diagonals();

}  // namespace sweepkit::bench
