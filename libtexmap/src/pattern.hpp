// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "sweepkit/texmap/procedural.hpp"
#include "tent_steps.hpp"

namespace sweepkit::texmap {

using Colors = std::span<const glm::vec3>;

/// A footprint in the pattern's own space, its scale applied: a tent, or for steps a box, of one `major` each
/// way along the one axis, of one `minor` along the other. Finite; a box lies along the pattern's axes.
struct PatternPlace {
  glm::dvec3 at{0.0};
  glm::dvec3 major{0.0};
  glm::dvec3 minor{0.0};
  FilterShape shape = FilterShape::kTent;

  /// Half widths along x, y and z of tents with the footprint's variances, or of the box.
  glm::dvec3 half_widths() const { return glm::sqrt(major * major + minor * minor); }
  /// The trace of its covariance, each axis stretched.
  double extent(const glm::dvec3& stretch) const {
    const glm::dvec3 a = stretch * major;
    const glm::dvec3 b = stretch * minor;
    return (glm::dot(a, a) + glm::dot(b, b)) / 6;
  }
};

/// What a kind takes where the scene says nothing: every default that is not the same for all kinds.
struct KindDefaults {
  ProceduralOn on;
  Colors colors;
  double turbulence;
  int octaves;
};
KindDefaults defaults_of(ProceduralKind kind);

/// A procedural with those in place. Views of its own.
struct Pattern {
  const Procedural& given;
  Colors colors;
  double turbulence;
  Octaves octaves;
  /// Units after which it comes round along u and v, 0 where it does not.
  std::int64_t period = 0;
};

/// Views of `procedural`, which must outlive it.
Pattern pattern_of(const Procedural& procedural);

/// Places and steps of the space that the procedural is on, in the pattern's own.
glm::dvec3 into_pattern(const Procedural& procedural, const glm::dvec3& v);

/// texmap::evaluate() of a pattern that is at hand.
glm::dvec3 color_of(const Pattern& pattern, const PatternFootprint& footprint);

/// Do dx and dy lie along two axes of the pattern, or along none?
bool lies_along_axes(const Procedural& procedural, const glm::dvec3& dx, const glm::dvec3& dy);

/// The mean of a pattern of steps over the box along its axes that the parallelogram of dx and dy about
/// `box.at` just fits into: the parallelogram's own where it lies along the axes. Exact where it meets less
/// than 4 cells across.
glm::dvec3 box_mean(const Pattern& pattern, const PatternFootprint& box);

/// The length, in units of the pattern, of the smallest thing in it: a band or joint of steps, a cell of the
/// finest octave of noise.
double finest_detail(const Pattern& pattern);

bool is_of_steps(ProceduralKind kind);

// Patterns of steps, exact for footprints along the axes (step_patterns.cpp, cell_pattern.cpp).
glm::dvec3 checker(const Pattern& pattern, const PatternPlace& place);
glm::dvec3 bands(const Pattern& pattern, const PatternPlace& place);
glm::dvec3 tiles(const Pattern& pattern, const PatternPlace& place);
glm::dvec3 brick(const Pattern& pattern, const PatternPlace& place);

/// The width of the narrowest band.
double narrowest_band(const Pattern& pattern);

// Patterns of noise, which take a footprint's extent alone (noise_patterns.cpp).
glm::dvec3 marble(const Pattern& pattern, const PatternPlace& place);
glm::dvec3 wood(const Pattern& pattern, const PatternPlace& place);
glm::dvec3 granite(const Pattern& pattern, const PatternPlace& place);
glm::dvec3 clouds(const Pattern& pattern, const PatternPlace& place);
glm::dvec3 plain_noise(const Pattern& pattern, const PatternPlace& place);
/// Cells of noise a unit, those of the finest of a kind's noises.
double cells_of(const Procedural& procedural);

/// Do bricks come round after a whole number of them and an even one of courses?
bool courses_come_round(const Procedural& procedural);

}  // namespace sweepkit::texmap
