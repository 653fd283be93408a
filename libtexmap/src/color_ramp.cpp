// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "color_ramp.hpp"

#include <algorithm>

namespace sweepkit::texmap {

double mean_kink(double t, const Cumulants& spread) {
  const double sigma = std::sqrt(std::max(0.0, spread.variance));
  // Six sigma off the density is below 1e-8.
  if (!(std::abs(t) < 6 * sigma)) return std::max(0.0, t);
  const double z = t / sigma;
  const double density = std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
  const double below = 0.5 * std::erfc(-z / std::numbers::sqrt2);
  // A footprint that has hardly taken anything from a noise has lost a spread that goes to 0 as the cumulants
  // do, and its shape would grow past all bounds: no part of a noise is further from normal than |noise| is
  // in skewness and noise in kurtosis (the cumulants of fractal_noise.cpp).
  constexpr double kMostSkewness = 0.8;
  constexpr double kMostKurtosis = 0.5;
  const double third = std::clamp(spread.third / (sigma * sigma * sigma), -kMostSkewness, kMostSkewness);
  const double fourth =
      std::clamp(spread.fourth / (sigma * sigma * sigma * sigma), -kMostKurtosis, kMostKurtosis);
  return sigma * (z * below + density * (1 - third / 6 * z + fourth / 24 * (z * z - 1)));
}

}  // namespace sweepkit::texmap
