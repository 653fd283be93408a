// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <span>

#include "sweepkit/texmap/noise.hpp"

// Colours along a line, straight between knots, averaged over a distribution of places on it. Such a ramp is
// a sum of kinks, and the mean of a kink is known: with z = t / sigma, phi and Phi the normal density and
// distribution, and the distribution's own shape by the Gram-Charlier series,
//   E (t + sigma x)+ = sigma (z Phi + phi - kappa_3/6 z phi + kappa_4/24 (z^2 - 1) phi).
// No sample is taken, so nothing can alias, and a spread of 0 is the ramp itself.

namespace sweepkit::texmap {

/// Where each colour stands.
struct RampKnot {
  double at;
  glm::vec3 color;
};

/// E max(0, t + x), x of mean 0 with that spread.
double mean_kink(double t, const Cumulants& spread);

/// The mean colour about `t` of the ramp whose knot i, 0 <= i < count, is knot(i): rising, and constant past
/// its ends.
template <class KnotAt>
glm::dvec3 mean_of_ramp(double t, const Cumulants& spread, std::size_t count, KnotAt&& knot) {
  RampKnot before = knot(std::size_t{0});
  glm::dvec3 sum(before.color);
  glm::dvec3 slope(0.0);
  for (std::size_t i = 1; i <= count; ++i) {
    const RampKnot here = i < count ? knot(i) : before;
    const glm::dvec3 next =
        i < count ? glm::dvec3(here.color - before.color) / (here.at - before.at) : glm::dvec3(0.0);
    sum += (next - slope) * mean_kink(t - before.at, spread);
    slope = next;
    before = here;
  }
  return glm::clamp(sum, glm::dvec3(0.0), glm::dvec3(1.0));
}

/// The same of colours that come round after 1, knots in [0, 1), for a normal distribution of `sigma`.
template <class KnotAt>
glm::dvec3 mean_of_wave(double t, double sigma, std::size_t count, KnotAt&& knot) {
  constexpr double kPi = std::numbers::pi;
  t -= std::floor(t);
  if (!(t < 1)) t = 0;  // just below a whole number
  // Calls use(knot, colour step to the next, way to it, kink) for every knot.
  const auto for_each_knot = [&](auto&& use) {
    RampKnot before = knot(count - 1);
    before.at -= 1;
    RampKnot here = knot(std::size_t{0});
    for (std::size_t i = 0; i < count; ++i) {
      RampKnot next = knot((i + 1) % count);
      if (i + 1 == count) next.at += 1;
      const glm::dvec3 slope = glm::dvec3(next.color - here.color) / (next.at - here.at);
      use(here, next, slope, slope - glm::dvec3(here.color - before.color) / (here.at - before.at));
      before = here;
      here = next;
    }
  };
  glm::dvec3 sum(0.0);
  if (sigma <= 0.25) {
    // The value, and each kink rounded off: what lies 6 sigma away does not show.
    for_each_knot(
        [&](const RampKnot& here, const RampKnot& next, const glm::dvec3& slope, const glm::dvec3& kink) {
          const double place = t < here.at ? t + 1 : t;
          if (place >= here.at && place < next.at) sum += glm::dvec3(here.color) + (place - here.at) * slope;
          if (sigma <= 0) return;
          for (int m = -2; m <= 2; ++m) {
            const double away = t - here.at - m;
            if (std::abs(away) > 6 * sigma) continue;
            sum += (mean_kink(away, {sigma * sigma, 0, 0}) - std::max(0.0, away)) * kink;
          }
        });
  } else {
    // Fourier: of the waves that are left the third is below 2e-5.
    for_each_knot([&](const RampKnot& here, const RampKnot& next, const glm::dvec3&, const glm::dvec3& kink) {
      sum += 0.5 * (next.at - here.at) * glm::dvec3(here.color + next.color);
      for (int k = 1; k <= 2; ++k) {
        const double frequency = 2 * kPi * k;
        const double left = std::exp(-0.5 * frequency * frequency * sigma * sigma);
        sum -= 2 * left * std::cos(frequency * (t - here.at)) / (frequency * frequency) * kink;
      }
    });
  }
  return glm::clamp(sum, glm::dvec3(0.0), glm::dvec3(1.0));
}

}  // namespace sweepkit::texmap
