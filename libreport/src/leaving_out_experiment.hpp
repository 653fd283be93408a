// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// What each scene does without (the plan that `render --explain` shows), and what that saves against the
/// same picture with every part switched on that leaves it as it is (`render --no-leave-out`). Throws
/// InputError where a scene cannot be read.
Experiment measure_leaving_out(const Effort& effort);

}  // namespace sweepkit::report
