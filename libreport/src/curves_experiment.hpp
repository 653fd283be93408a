// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// Points of Bezier segments by four methods: error against time, by the degree.
Experiment measure_curves(const Effort& effort);

/// Arc lengths by four methods: relative error against time, by the number of steps.
Experiment measure_lengths(const Effort& effort);

}  // namespace sweepkit::report
