// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

// Step functions under a tent or a box of half width h, in closed form. Every periodic pattern of steps is a
// sum of differences of one function, the staircase floor(x). Where the tent holds a single step, its share
// is two parabolas; wider ones take the second difference of the staircase's second integral,
//   floor(x) = x - 1/2 - B1({x}),  whose second integral is the periodic Bernoulli polynomial B3({x}) / 6,
// which does not grow with x, so nothing is lost far from the origin. A box takes the first difference of the
// first integral, B2({x}) / 2. h = 0 is the step itself.

namespace sweepkit::texmap {

enum class FilterShape { kTent, kBox };

/// The share of the tent or box about 0 that lies below t: 0 to 1 over t = -h to h.
inline double share_below(double t, double h, FilterShape shape = FilterShape::kTent) {
  if (!(h > 0)) return t > 0 ? 1 : 0;
  if (t >= h) return 1;
  if (t < -h) return 0;
  const double s = t / h;
  if (shape == FilterShape::kBox) return 0.5 * (1 + s);
  return s < 0 ? 0.5 * (1 + s) * (1 + s) : 1 - 0.5 * (1 - s) * (1 - s);
}

/// The mean of floor(x) under it.
inline double filtered_floor(double x, double h, FilterShape shape = FilterShape::kTent) {
  if (!(h > 0)) return std::floor(x);
  if (h <= 0.5) {
    const double step = std::floor(x + 0.5);
    return step - 1 + share_below(x - step, h, shape);
  }
  if (shape == FilterShape::kBox) {
    const auto b2_over_2 = [](double t) {
      const double f = t - std::floor(t);
      return 0.5 * f * (f - 1);
    };
    return x - 0.5 - (b2_over_2(x + h) - b2_over_2(x - h)) / (2 * h);
  }
  const auto b3_over_6 = [](double t) {
    const double f = t - std::floor(t);
    return f * (f * (f - 1.5) + 0.5) / 6;
  };
  return x - 0.5 - (b3_over_6(x + h) - 2 * b3_over_6(x) + b3_over_6(x - h)) / (h * h);
}

/// The mean of the pattern of period 1 that is 1 from `from` to `to`, 0 elsewhere. 0 <= from <= to <= 1.
inline double filtered_pulse(double x, double from, double to, double h,
                             FilterShape shape = FilterShape::kTent) {
  if (to - from >= 1) return 1;
  const double f = x - std::floor(x);
  return std::clamp(filtered_floor(f - from, h, shape) - filtered_floor(f - to, h, shape), 0.0, 1.0);
}

}  // namespace sweepkit::texmap
