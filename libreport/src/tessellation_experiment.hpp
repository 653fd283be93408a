// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// The largest distance from a mesh to the surface that it stands for, by counts of cells and by tolerance.
Experiment measure_tessellation(const Effort& effort);

}  // namespace sweepkit::report
