// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// The five ways from a hit on a triangle to its texture coordinates: error, time, operations and memory.
Experiment measure_triangle_maps(const Effort& effort);

}  // namespace sweepkit::report
