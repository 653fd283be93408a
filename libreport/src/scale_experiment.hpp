// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// Time and memory of generating, rendering and exporting against the scene's size and the threads.
Experiment measure_scale(const Effort& effort);

}  // namespace sweepkit::report
