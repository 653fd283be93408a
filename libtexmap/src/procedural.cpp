// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A pixel filter that is a tent of one pixel each way falls on a pattern as a tent along dx times one along
// dy. Turned to its principal axes it is a tent along `major` times one along `minor`, with the same
// covariance. A tent is a sum of 2 n - 1 narrower ones, exactly (the refinement of the linear B-spline), so a
// long footprint that lies askew is cut along its major axis until each piece is about as long as it is wide:
// then its shadows on the pattern's axes tell all there is to know of it. Footprints along the axes are not
// cut: steps under them are exact.

#include "sweepkit/texmap/procedural.hpp"

#include <algorithm>
#include <cmath>

#include "pattern.hpp"

namespace sweepkit::texmap {
namespace {

// Past 2^52 a double has no fraction left; patterns are held there instead of turned to noise.
constexpr double kFarthest = 4503599627370496.0;
// Wider than any pattern's fade, and its square and those of its multiples are numbers.
constexpr double kWidest = 1e12;

bool is_whole(double scale) {
  return scale >= 1 && scale == std::floor(scale);
}

glm::dvec3 value(const Pattern& pattern, const PatternPlace& place) {
  switch (pattern.given.kind) {
    case ProceduralKind::kChecker:
      return checker(pattern, place);
    case ProceduralKind::kTiles:
      return tiles(pattern, place);
    case ProceduralKind::kBands:
      return bands(pattern, place);
    case ProceduralKind::kBrick:
      return brick(pattern, place);
    case ProceduralKind::kMarble:
      return marble(pattern, place);
    case ProceduralKind::kWood:
      return wood(pattern, place);
    case ProceduralKind::kGranite:
      return granite(pattern, place);
    case ProceduralKind::kClouds:
      return clouds(pattern, place);
    case ProceduralKind::kNoise:
      return plain_noise(pattern, place);
  }
  return glm::dvec3(pattern.colors[0]);
}

// Turns the steps to the principal axes of what they span.
void turn_to_axes(glm::dvec3& major, glm::dvec3& minor) {
  const double a = glm::dot(major, major);
  const double b = glm::dot(minor, minor);
  const double c = glm::dot(major, minor);
  const double angle = 0.5 * std::atan2(2 * c, a - b);
  const glm::dvec3 first = std::cos(angle) * major + std::sin(angle) * minor;
  minor = std::cos(angle) * minor - std::sin(angle) * major;
  major = first;
}

// Into how many pieces along its major axis.
int pieces_of(const Pattern& pattern, const PatternPlace& place) {
  constexpr int kMostOfSteps = 16;
  constexpr int kMostOfNoise = 4;
  const double longest = glm::length(place.major);
  const double aspect = longest / std::max(glm::length(place.minor), 1e-3 * longest);
  if (!is_of_steps(pattern.given.kind)) {
    const double finest = cells_of(pattern.given) * std::exp2(pattern.octaves.count - 1);
    if (finest * longest < 0.2) return 1;  // even the finest octave is seen magnified
    return static_cast<int>(std::clamp(std::nearbyint(aspect), 1.0, static_cast<double>(kMostOfNoise)));
  }
  // Steps: until no two of the pattern's axes hang together much.
  for (int n = 1; n < kMostOfSteps; n *= 2) {
    const glm::dvec3 major = place.major / static_cast<double>(n);
    const glm::dvec3 half = PatternPlace{{}, major, place.minor}.half_widths();
    const auto hangs = [&](glm::length_t i, glm::length_t j) {
      return std::abs(major[i] * major[j] + place.minor[i] * place.minor[j]) > 0.25 * half[i] * half[j];
    };
    if (n > aspect || (!hangs(0, 1) && !hangs(1, 2) && !hangs(0, 2))) return n;
  }
  return kMostOfSteps;
}

// Where in the pattern a place is.
glm::dvec3 place_in(const Pattern& pattern, const glm::dvec3& at) {
  glm::dvec3 place = into_pattern(pattern.given, at);
  if (!std::isfinite(place.x + place.y + place.z)) place = glm::dvec3(0.0);
  place = glm::clamp(place, glm::dvec3(-kFarthest), glm::dvec3(kFarthest));
  if (pattern.period > 0) {  // the same bits one unit on
    const auto period = static_cast<double>(pattern.period);
    place -= period * glm::floor(place / period);
  }
  return place;
}

}  // namespace

bool is_of_steps(ProceduralKind kind) {
  return kind <= ProceduralKind::kBrick;
}

glm::dvec3 into_pattern(const Procedural& procedural, const glm::dvec3& v) {
  if (procedural.on == ProceduralOn::kPosition) {
    if (procedural.kind == ProceduralKind::kTiles) return procedural.scale * glm::dvec3(v.x, v.z, 0);
    if (procedural.kind == ProceduralKind::kBrick) return procedural.scale * glm::dvec3(v.x - v.z, v.y, 0);
  }
  return procedural.scale * v;
}

Pattern pattern_of(const Procedural& procedural) {
  const KindDefaults defaults = defaults_of(procedural.kind);
  Pattern pattern{.given = procedural,
                  .colors = procedural.colors.size() < 2 ? defaults.colors : Colors(procedural.colors),
                  .turbulence = procedural.turbulence.value_or(defaults.turbulence),
                  .octaves = {procedural.octaves.value_or(defaults.octaves), procedural.basis}};
  pattern.octaves.is_flat = procedural.on == ProceduralOn::kUv;
  if (repeats_in_unit_square(procedural)) {
    pattern.period = static_cast<std::int64_t>(procedural.scale);
    pattern.octaves.period_x = pattern.octaves.period_y = pattern.period;
  }
  return pattern;
}

glm::dvec3 color_of(const Pattern& pattern, const PatternFootprint& footprint) {
  const Procedural& procedural = pattern.given;
  PatternPlace place{place_in(pattern, footprint.at), into_pattern(procedural, footprint.dx),
                     into_pattern(procedural, footprint.dy)};
  if (place.major == glm::dvec3(0.0) && place.minor == glm::dvec3(0.0)) return value(pattern, place);
  for (glm::dvec3* axis : {&place.major, &place.minor}) {
    const double size = std::abs(axis->x) + std::abs(axis->y) + std::abs(axis->z);
    if (!std::isfinite(size)) return glm::dvec3(mean_of(procedural));
    if (size > kWidest) *axis *= kWidest / size;
  }
  turn_to_axes(place.major, place.minor);
  const int pieces = pieces_of(pattern, place);
  const glm::dvec3 step = place.major / static_cast<double>(pieces);
  glm::dvec3 sum(0.0);
  for (int k = 1 - pieces; k < pieces; ++k) {
    const double weight = static_cast<double>(pieces - std::abs(k)) / (pieces * pieces);
    sum += weight * value(pattern, {place.at + static_cast<double>(k) * step, step, place.minor});
  }
  return sum;
}

bool lies_along_axes(const Procedural& procedural, const glm::dvec3& dx, const glm::dvec3& dy) {
  const glm::dvec3 across = glm::abs(into_pattern(procedural, dx));
  const glm::dvec3 down = glm::abs(into_pattern(procedural, dy));
  // What rounding leaves beside an axis: a texel in a billion.
  const double least = 1e-9 * std::max({across.x, across.y, across.z, down.x, down.y, down.z});
  if (!(least < 1e-9 * kWidest)) return false;
  const auto axes = [&](const glm::dvec3& side) {
    return (side.x > least ? 1 : 0) + (side.y > least ? 1 : 0) + (side.z > least ? 1 : 0);
  };
  if (axes(across) > 1 || axes(down) > 1) return false;
  for (glm::length_t k = 0; k < 3; ++k) {
    if (across[k] > least && down[k] > least) return false;
  }
  return true;
}

glm::dvec3 box_mean(const Pattern& pattern, const PatternFootprint& box) {
  const glm::dvec3 half =
      0.5 * (glm::abs(into_pattern(pattern.given, box.dx)) + glm::abs(into_pattern(pattern.given, box.dy)));
  return value(pattern, {place_in(pattern, box.at), half, {}, FilterShape::kBox});
}

double finest_detail(const Pattern& pattern) {
  const Procedural& given = pattern.given;
  // A joint, or what it leaves of a cell; none is no detail.
  const double finest_octave = std::exp2(std::clamp(pattern.octaves.count, 1, 16) - 1);
  const auto joint = [](double width) { return width > 0 && width < 1 ? std::min(width, 1 - width) : 1.0; };
  switch (given.kind) {
    case ProceduralKind::kChecker:
      return 0.5;
    case ProceduralKind::kTiles:
      return joint(given.grout);
    case ProceduralKind::kBands:
      return narrowest_band(pattern);
    case ProceduralKind::kBrick:
      return std::min(1.0, joint(given.mortar) / given.ratio);
    case ProceduralKind::kWood:
      // Two octaves of fibres, which cells_of() counts where there are any, on bent rings.
      return 1 / std::max(2 * cells_of(given), 2 * finest_octave);
    default:
      return 1 / (cells_of(given) * finest_octave);
  }
}

glm::vec3 evaluate(const Procedural& procedural, const PatternFootprint& footprint) {
  return color_of(pattern_of(procedural), footprint);
}

glm::vec3 evaluate(const Procedural& procedural, glm::dvec2 uv, const glm::dvec3& position) {
  return evaluate(procedural, {procedural.on == ProceduralOn::kUv ? glm::dvec3(uv, 0) : position});
}

glm::vec3 mean_of(const Procedural& procedural) {
  constexpr double kWide = 1e9;  // in units of the pattern
  return value(pattern_of(procedural), {{}, glm::dvec3(kWide), glm::dvec3(0.0)});
}

bool repeats_in_unit_square(const Procedural& procedural) {
  if (procedural.on != ProceduralOn::kUv || !is_whole(procedural.scale) || procedural.scale > 1e9)
    return false;
  switch (procedural.kind) {
    // Two tile colours stand like a chessboard, which closes after an even number.
    case ProceduralKind::kTiles:
      return !(procedural.colors.size() == 3 || procedural.colors.empty()) ||
             std::fmod(procedural.scale, 2) == 0;
    case ProceduralKind::kBrick:
      return courses_come_round(procedural);
    case ProceduralKind::kWood:
      return is_whole(procedural.scale * procedural.rings);
    case ProceduralKind::kChecker:
    case ProceduralKind::kBands:
    case ProceduralKind::kMarble:
    case ProceduralKind::kGranite:
    case ProceduralKind::kClouds:
    case ProceduralKind::kNoise:
      return true;
  }
  return false;
}

}  // namespace sweepkit::texmap
