// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Perlin85] for marble as a wave bent by turbulence and for colours along a sum of noise, on
// [Peachey85] for wood as rings in space. Each is a ramp of colours along a number that noise makes; under a
// footprint that number is spread, and the ramp is averaged over the spread (color_ramp.hpp).

#include <algorithm>
#include <cmath>
#include <numbers>

#include "color_ramp.hpp"
#include "pattern.hpp"

namespace sweepkit::texmap {
namespace {

constexpr double kPi = std::numbers::pi;

// Far from each other in every noise, so that what starts there has nothing in common.
glm::dvec3 elsewhere(int which) {
  return static_cast<double>(which) * glm::dvec3(71.3, 37.9, 53);
}

Octaves stretched(Octaves octaves, std::int64_t x, std::int64_t y) {
  octaves.period_x *= x;
  octaves.period_y *= y;
  return octaves;
}

// Above which number of a normal distribution does a share p lie? [Abramowitz64, 26.2.23], within 4.5e-4.
double upper_quantile(double p) {
  const double t = std::sqrt(-2 * std::log(std::clamp(std::min(p, 1 - p), 1e-12, 0.5)));
  const double z =
      t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
  return p < 0.5 ? z : -z;
}

constexpr std::array<std::int64_t, 4> kGrains = {16, 22, 30, 40};  // of granite's minerals
constexpr std::int64_t kCloudCells = 3;
constexpr std::int64_t kNoiseCells = 4;

// Fibres of wood are thinner than its rings.
std::int64_t fibres_of(const Procedural& procedural) {
  return static_cast<std::int64_t>(std::clamp(std::ceil(10 * procedural.rings), 1.0, 1e6));
}

std::size_t last_of(Colors colors) {
  return colors.size() - 1;
}

}  // namespace

// The vein is where |sin| of the phase is 0; |sin| runs through the colours, so the veins are thin.
glm::dvec3 marble(const Pattern& pattern, const PatternPlace& place) {
  // On (u,v) the lattice is turned by whole numbers, which keeps it coming round: else its cells and the
  // waves would be of one length, and hang together.
  const bool is_flat = pattern.octaves.is_flat;
  const glm::dvec3& p = place.at;
  const glm::dvec3 lattice = is_flat ? glm::dvec3(2 * p.x + p.y, 2 * p.y - p.x, 0) : p;
  const FilteredNoise bend =
      turbulence(lattice, place.extent(glm::dvec3(is_flat ? std::sqrt(5.0) : 1.0)), pattern.octaves);
  const double strength = pattern.turbulence / (2 * kPi);
  const double variance = place.extent({1, 0, 0}) + strength * strength * bend.lost.variance;
  const Colors colors = pattern.colors;
  const std::size_t last = last_of(colors);
  const auto knot = [&](std::size_t i) -> RampKnot {
    if (i > last)
      return {1 - std::asin(static_cast<double>(2 * last - i) / static_cast<double>(last)) / kPi,
              colors[2 * last - i]};
    return {std::asin(static_cast<double>(i) / static_cast<double>(last)) / kPi, colors[i]};
  };
  return mean_of_wave(place.at.x + strength * bend.mean + 0.25, std::sqrt(variance), 2 * last, knot);
}

// Spring wood grows wide and light, autumn wood thin and dark, and spring comes at once.
glm::dvec3 wood(const Pattern& pattern, const PatternPlace& place) {
  const Procedural& given = pattern.given;
  const bool is_board = given.on == ProceduralOn::kUv;
  constexpr double kAutumnEnds = 0.9;
  // Trunks grow straight: noise is long along y. On a board whole cells keep it coming round.
  constexpr std::int64_t kAcross = 2;
  const glm::dvec3 stretch(kAcross, is_board ? 1 : 0.35, kAcross);
  const FilteredNoise bend =
      fractal_sum(stretch * place.at, place.extent(stretch), stretched(pattern.octaves, kAcross, 1));

  // How far a pixel's step takes the rings, from both sides: at the trunk's middle they turn round.
  const auto radius = [&](const glm::dvec3& p) { return is_board ? p.x : std::hypot(p.x, p.z); };
  const double here = radius(place.at);
  double steps = 0;
  for (const glm::dvec3& axis : {place.major, place.minor}) {
    if (axis == glm::dvec3(0.0)) continue;
    const double forth = radius(place.at + axis) - here;
    const double back = radius(place.at - axis) - here;
    steps += (forth * forth + back * back) / 12;
  }
  const double sigma = std::sqrt(given.rings * given.rings * steps +
                                 pattern.turbulence * pattern.turbulence * bend.lost.variance);
  const Colors colors = pattern.colors;
  const auto knot = [&](std::size_t i) -> RampKnot {
    return {kAutumnEnds * static_cast<double>(i) / static_cast<double>(last_of(colors)), colors[i]};
  };
  const glm::dvec3 color =
      mean_of_wave(given.rings * here + pattern.turbulence * bend.mean, sigma, colors.size(), knot);

  if (given.grain <= 0) return color;
  const std::int64_t across = fibres_of(given);
  const glm::dvec3 fine(static_cast<double>(across), 3, static_cast<double>(across));
  Octaves fibres = stretched(pattern.octaves, across, 3);
  fibres.count = 2;
  const double light = fractal_sum(fine * place.at + elsewhere(1), place.extent(fine), fibres).mean;
  return glm::clamp(color * (1 + given.grain * std::min(light, 1.0)), glm::dvec3(0.0), glm::dvec3(1.0));
}

glm::dvec3 granite(const Pattern& pattern, const PatternPlace& place) {
  // Each mineral covers an equal share of what it is laid on, in grains as fine as the ones before or finer.
  constexpr double kThreshold = 0.5244;  // deviations above which 30 % lie
  constexpr double kEdge = 0.12;         // half the way from one mineral to the next, in deviations
  glm::dvec3 color(pattern.colors[0]);
  for (std::size_t i = 1; i < pattern.colors.size(); ++i) {
    const std::int64_t grains = kGrains[std::min(i, kGrains.size()) - 1];
    const glm::dvec3 stretch(static_cast<double>(grains));
    const Octaves octaves = stretched(pattern.octaves, grains, grains);
    const FilteredNoise value =
        fractal_sum(stretch * place.at + elsewhere(static_cast<int>(i)), place.extent(stretch), octaves);
    const double sigma = std::sqrt(cumulants_of_fractal_sum(octaves).variance);
    const double above = value.mean - kThreshold * sigma;
    const double half = kEdge * sigma;
    const double covered =
        (mean_kink(above + half, value.lost) - mean_kink(above - half, value.lost)) / (2 * half);
    color = glm::mix(color, glm::dvec3(pattern.colors[i]), std::clamp(covered, 0.0, 1.0));
  }
  return color;
}

glm::dvec3 clouds(const Pattern& pattern, const PatternPlace& place) {
  const glm::dvec3 stretch(static_cast<double>(kCloudCells));
  const Octaves octaves = stretched(pattern.octaves, kCloudCells, kCloudCells);
  const FilteredNoise value = fractal_sum(stretch * place.at, place.extent(stretch), octaves);
  const double sigma = std::sqrt(cumulants_of_fractal_sum(octaves).variance);
  constexpr double kThick = 2;  // deviations from a cloud's edge to where it is white
  const double edge = upper_quantile(pattern.given.coverage);
  const Colors colors = pattern.colors;
  const auto knot = [&](std::size_t i) -> RampKnot {
    return {sigma * (edge + kThick * static_cast<double>(i) / static_cast<double>(last_of(colors))),
            colors[i]};
  };
  return mean_of_ramp(value.mean, value.lost, colors.size(), knot);
}

glm::dvec3 plain_noise(const Pattern& pattern, const PatternPlace& place) {
  const glm::dvec3 stretch(static_cast<double>(kNoiseCells));
  const Octaves octaves = stretched(pattern.octaves, kNoiseCells, kNoiseCells);
  const FilteredNoise value = fractal_sum(stretch * place.at, place.extent(stretch), octaves);
  const double sigma = std::sqrt(cumulants_of_fractal_sum(octaves).variance);
  constexpr double kReach = 2.5;  // deviations; what lies beyond takes the ends' colours
  const Colors colors = pattern.colors;
  const auto knot = [&](std::size_t i) -> RampKnot {
    return {sigma * kReach * (2 * static_cast<double>(i) / static_cast<double>(last_of(colors)) - 1),
            colors[i]};
  };
  return mean_of_ramp(value.mean, value.lost, colors.size(), knot);
}

double cells_of(const Procedural& procedural) {
  switch (procedural.kind) {
    case ProceduralKind::kMarble:
      return procedural.on == ProceduralOn::kUv ? std::sqrt(5.0) : 1;
    case ProceduralKind::kWood:
      return procedural.grain > 0 ? static_cast<double>(fibres_of(procedural)) : 2;
    case ProceduralKind::kGranite:
      return static_cast<double>(kGrains.back());
    case ProceduralKind::kClouds:
      return static_cast<double>(kCloudCells);
    case ProceduralKind::kNoise:
      return static_cast<double>(kNoiseCells);
    default:
      return 1;
  }
}

}  // namespace sweepkit::texmap
