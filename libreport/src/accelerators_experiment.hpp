// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// Building and tracing by every accelerator, against the number of triangles.
Experiment measure_accelerators(const Effort& effort);

}  // namespace sweepkit::report
