// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "section.hpp"

#include "cap.hpp"
#include "whole_angle.hpp"

namespace sweepkit::sweep {

Section make_section(const Curve2& contour, int cells, double crease_deg, UvBy by) {
  std::vector<Station> stations = place_stations(contour, cells);
  Section section;
  section.is_closed = contour.is_closed();
  double direction = 1;
  if (section.is_closed) {
    std::vector<glm::dvec2> outline;
    for (const Station& station : stations) outline.push_back(contour.evaluate(station.out).position);
    outline.pop_back();
    if (twice_signed_area(outline) < 0) {
      stations = reversed(contour, std::move(stations));
      direction = -1;
    }
  }
  section.fractions = texture_fractions(stations, by);
  const double crease_cos = cos_sin_deg(crease_deg).cos;
  for (const Station& station : stations) {
    SectionPoint point{contour.evaluate(station.out).position, direction * contour.tangent(station.in),
                       direction * contour.tangent(station.out)};
    const bool breaks = station.is_corner && glm::dot(point.tangent_in, point.tangent_out) < crease_cos;
    if (station.is_corner && !breaks) {
      point.tangent_in = point.tangent_out = glm::normalize(point.tangent_in + point.tangent_out);
    } else if (!station.is_corner) {
      point.tangent_in = point.tangent_out;
    }
    section.points.push_back(point);
    section.breaks.push_back(breaks);
  }
  // One place, the same bits.
  if (section.is_closed) section.points.back() = section.points.front();
  return section;
}

}  // namespace sweepkit::sweep
