// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "light_samples.hpp"

#include <cmath>
#include <numbers>

#include "position_hash.hpp"

namespace sweepkit::render {
namespace {

double fraction(double value) {
  return value - std::floor(value);
}

// The bits of i behind the binary point, the lowest first.
double radical_inverse(std::size_t i) {
  double sum = 0;
  for (double digit = 0.5; i > 0; i >>= 1, digit /= 2) sum += static_cast<double>(i & 1) * digit;
  return sum;
}

}  // namespace

std::array<glm::dvec2, kLightSamples> disc_samples(std::uint64_t seed) {
  static const std::array<double, kLightSamples> kTurns = [] {
    std::array<double, kLightSamples> turns{};
    for (std::size_t i = 0; i < kLightSamples; ++i) turns[i] = radical_inverse(i);
    return turns;
  }();
  const glm::dvec2 shift = fractions_of(seed);
  std::array<glm::dvec2, kLightSamples> samples;
  for (std::size_t i = 0; i < kLightSamples; ++i) {
    const double radius = std::sqrt(fraction((static_cast<double>(i) + 0.5) / kLightSamples + shift.x));
    const double angle = 2 * std::numbers::pi * (kTurns[i] + shift.y);
    samples[i] = radius * glm::dvec2(std::cos(angle), std::sin(angle));
  }
  return samples;
}

}  // namespace sweepkit::render
