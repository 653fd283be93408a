// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// Rotation-minimizing frames by four methods: largest angle error against time, by the number of steps.
Experiment measure_frames(const Effort& effort);

}  // namespace sweepkit::report
