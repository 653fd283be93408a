// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// Whole pictures: error against time for every filter and antialiasing. With it, of the same measurements,
/// "speedups" at equal error and "cost" of filtering beside the paper's.
Experiment measure_pictures(const Effort& effort);

}  // namespace sweepkit::report
