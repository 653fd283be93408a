// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// The catalogue of stiff and extreme cases: what each reached against the bound that is promised.
Experiment measure_stability(const Effort& effort);

}  // namespace sweepkit::report
