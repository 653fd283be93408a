// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

namespace sweepkit::render {

/// How far a picture is from the true one, each pixel the mean of the light over its square: root of the mean
/// squared error over R, G and B in linear light (texmap::rmse), estimated without a reference.
/// docs/algorithms/error-estimate.md tells how, and how far off it is.
struct ErrorEstimate {
  double rmse = 0;
  std::uint64_t checked_pixels = 0;  ///< drawn again, and often, to check
  std::uint64_t checking_rays = 0;   ///< eye rays for that, not counted in Statistics
  double seconds = 0;                ///< the checks took, wall clock; not part of Statistics::picture_seconds
};

/// Refine a picture of one ray a pixel, where its error is largest for a ray, as far as is asked: one of the
/// two. At most kMostRefiningRays a pixel.
struct Goal {
  double error = 0;                      ///< until the estimate is at most this; over 0, or 0: none
  std::function<double()> seconds_left;  ///< until this is about 0, called now and then from one thread
};

}  // namespace sweepkit::render
