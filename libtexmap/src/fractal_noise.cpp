// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Perlin85] for the sums, and on [Norton82] for fading out what is finer than a pixel ("clamping").
// Departs from them
//   - in the fade: what a filter leaves of an octave, n * h, is best foretold from its value n in the middle
//     as a n, where a = E[n (n * h)] / E[n^2]. That was measured for tents of every size on planes through
//     the noise and is (1 + k e)^-2 within 0.03, e the trace of the filter's covariance. Below 1 % it is
//     taken down to 0, evenly, so that no octave goes with a jerk and none is computed for nothing;
//   - in keeping account of what goes: under a footprint the values of an octave lie about a n with the
//     cumulants (1 - a^m) kappa_m, so that a colour ramp can be averaged over them.
//
// Symbols: kappa_m the cumulant of order m of an octave's values, a its fade, g its strength.

#include <algorithm>
#include <cmath>

#include "lattice_noise.hpp"
#include "sweepkit/texmap/noise.hpp"

namespace sweepkit::texmap {
namespace {

// The values of one octave over all of space, or over all planes of the lattice where it is flat: measured on
// 4 million points, good to the last digit given or to the one before.
struct Values {
  double mean;
  Cumulants spread;
  double fade;  // k
};

Values values_of_noise(const Octaves& octaves) {
  const bool is_improved = octaves.basis == NoiseBasis::kPerlin2002;
  if (octaves.is_flat)
    return is_improved ? Values{0, {0.0620, 0, -0.00129}, 2.3} : Values{0, {0.02988, 0, -0.00017}, 2.0};
  return is_improved ? Values{0, {0.0729, 0, -0.00243}, 1.7} : Values{0, {0.03325, 0, -0.00041}, 1.5};
}
Values values_of_magnitude(const Octaves& octaves) {
  const bool is_improved = octaves.basis == NoiseBasis::kPerlin2002;
  if (octaves.is_flat) {
    return is_improved ? Values{0.2016, {0.02137, 0.00247, 0.000035}, 4.5}
                       : Values{0.1380, {0.01082, 0.00097, 0.000023}, 3.7};
  }
  return is_improved ? Values{0.2201, {0.02444, 0.00265, -0.000079}, 4.0}
                     : Values{0.1480, {0.01133, 0.00092, 0.000005}, 3.4};
}

double fade(double extent, double k) {
  constexpr double kEnd = 0.01;
  if (extent == 0) return 1;
  const double step = 1 + k * extent;
  const double left = 1 / (step * step);
  return left > kEnd ? (left - kEnd) / (1 - kEnd) : 0;  // 0 for NaN, too
}

// A rotation by an angle that is no part of a turn about an axis that is none of the lattice's: the rows of
// (2, -14, 23), (26, 7, 2), (-7, 22, 14) have length 27. Then away from the origin.
constexpr glm::dvec3 kAway(0.37, 0.61, 0.23);
glm::dvec3 turned(const glm::dvec3& p) {
  return glm::dvec3(2 * p.x - 14 * p.y + 23 * p.z, 26 * p.x + 7 * p.y + 2 * p.z,
                    -7 * p.x + 22 * p.y + 14 * p.z) /
             27.0 +
         kAway;
}

template <class OfNoise>
FilteredNoise sum(const glm::dvec3& position, double extent, const Octaves& octaves, const Values& values,
                  OfNoise&& of_noise) {
  FilteredNoise result;
  glm::dvec3 p = position;
  const double plane = 101 * std::floor(position.z);  // and those beside it, for the other octaves
  std::int64_t period_x = octaves.period_x;
  std::int64_t period_y = octaves.period_y;
  double strength = 1;
  const int count = std::clamp(octaves.count, 1, 16);
  for (int i = 0; i < count; ++i) {
    if (!octaves.is_flat) p = turned(p);
    const double a = fade(extent, values.fade);
    double value = values.mean;
    if (a > 0) {
      const glm::dvec3 place =
          octaves.is_flat
              ? glm::dvec3(glm::dvec2(p) + static_cast<double>(i + 1) * glm::dvec2(kAway), plane + i)
              : p;
      value += a * (of_noise(lattice_noise(place, octaves.basis, period_x, period_y)) - values.mean);
    }
    result.mean += strength * value;
    const double g2 = strength * strength;
    const double a2 = a * a;
    result.lost.variance += g2 * (1 - a2) * values.spread.variance;
    result.lost.third += g2 * strength * (1 - a2 * a) * values.spread.third;
    result.lost.fourth += g2 * g2 * (1 - a2 * a2) * values.spread.fourth;
    strength /= 2;
    p *= 2;
    extent *= 4;
    period_x *= 2;
    period_y *= 2;
  }
  return result;
}

}  // namespace

FilteredNoise fractal_sum(const glm::dvec3& position, double extent, const Octaves& octaves) {
  return sum(position, extent, octaves, values_of_noise(octaves), [](double n) { return n; });
}

FilteredNoise turbulence(const glm::dvec3& position, double extent, const Octaves& octaves) {
  return sum(position, extent, octaves, values_of_magnitude(octaves), [](double n) { return std::abs(n); });
}

Cumulants cumulants_of_fractal_sum(const Octaves& octaves) {
  return fractal_sum({}, HUGE_VAL, octaves).lost;
}

}  // namespace sweepkit::texmap
