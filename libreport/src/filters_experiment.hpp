// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// Texture filters on a plane that runs to the horizon, and OpenImageIO's texture system beside them.
Experiment measure_filters(const Effort& effort);

}  // namespace sweepkit::report
