// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "stations.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

/// A contour made ready for the inner loops: points with the directions in which it arrives and leaves. An
/// outer outline runs counter-clockwise and a hole clockwise, turned round if it was drawn the other way; a
/// closed one has its first point again as its last.
struct SectionPoint {
  glm::dvec2 position;
  glm::dvec2 tangent_in;  ///< of unit length, but for a morph's keys (morph.hpp)
  glm::dvec2 tangent_out;
};

struct Section {
  std::vector<SectionPoint> points;
  std::vector<bool> breaks;       ///< does the normal break here?
  std::vector<bool> corners;      ///< a corner of the contour, which is a vertex at any tessellation
  std::vector<double> fractions;  ///< 0 to 1, for the texture
  bool is_closed = false;
};

struct SectionOptions {
  double crease_deg = 30;
  UvBy by = UvBy::kArcLength;
  bool is_hole = false;
};

/// Throws InputError for a contour that lies on one line or has too few cells to enclose anything, and for a
/// crease angle that is none.
Section make_section(const Curve2& contour, int cells, const SectionOptions& options);

/// The same from stations placed already, with `direction` -1 where they walk against the contour.
Section make_section(const Curve2& contour, const std::vector<Station>& stations, double direction,
                     const SectionOptions& options);

/// Does the contour have to be walked backwards: an outer one drawn clockwise, a hole drawn
/// counter-clockwise? Throws as make_section() does.
bool is_drawn_backwards(const Curve2& contour, const std::vector<Station>& stations, bool is_hole);

/// The positions of a closed section, each once.
std::vector<glm::dvec2> outline_of(const Section& section);

/// The farthest that a section lies from its origin.
double reach_of(const Section& section);

/// Two directions whose product is below this bend by more than `crease_deg`. Throws InputError unless 0 <=
/// crease_deg <= 180.
double crease_cosine(double crease_deg);

}  // namespace sweepkit::sweep
