// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "stations.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

/// A contour made ready for the inner loops: points with the unit tangents in which it arrives and leaves. A
/// closed contour runs counter-clockwise, turned round if it was drawn the other way, and has its first point
/// again as its last.
struct SectionPoint {
  glm::dvec2 position;
  glm::dvec2 tangent_in;
  glm::dvec2 tangent_out;
};

struct Section {
  std::vector<SectionPoint> points;
  std::vector<bool> breaks;       ///< does the normal break here?
  std::vector<double> fractions;  ///< 0 to 1, for the texture
  bool is_closed = false;
};

Section make_section(const Curve2& contour, int cells, double crease_deg, UvBy by);

}  // namespace sweepkit::sweep
