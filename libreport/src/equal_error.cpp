// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "equal_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sweepkit::report {

double seconds_to_reach(std::span<const ErrorAtTime> knob, double psnr_db) {
  const auto reached =
      std::find_if(knob.begin(), knob.end(), [&](const ErrorAtTime& one) { return one.psnr_db >= psnr_db; });
  if (reached == knob.end()) return std::numeric_limits<double>::quiet_NaN();
  if (reached == knob.begin() || std::isinf(reached->psnr_db)) return reached->seconds;
  const ErrorAtTime& below = *(reached - 1);
  const double share = (psnr_db - below.psnr_db) / (reached->psnr_db - below.psnr_db);
  return below.seconds * std::pow(reached->seconds / below.seconds, share);
}

double least_seconds(std::span<const ErrorAtTime> any, double psnr_db) {
  double least = std::numeric_limits<double>::infinity();
  for (const ErrorAtTime& one : any) {
    if (one.psnr_db >= psnr_db) least = std::min(least, one.seconds);
  }
  return std::isinf(least) ? std::numeric_limits<double>::quiet_NaN() : least;
}

}  // namespace sweepkit::report
