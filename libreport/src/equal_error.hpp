// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace sweepkit::report {

struct ErrorAtTime {
  double seconds = 0;
  double psnr_db = 0;
};

/// The time in which a method whose knob is turned from the first of these to the last reaches an error:
/// between two of them the logarithms of time and error are interpolated. NaN where none reaches it.
double seconds_to_reach(std::span<const ErrorAtTime> knob, double psnr_db);

/// The least time of those that reach it; NaN where none does.
double least_seconds(std::span<const ErrorAtTime> any, double psnr_db);

}  // namespace sweepkit::report
