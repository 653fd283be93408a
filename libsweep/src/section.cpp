// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "section.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "number_text.hpp"
#include "sweepkit/error.hpp"
#include "triangulate.hpp"
#include "whole_angle.hpp"

namespace sweepkit::sweep {
namespace {

// A loop this thin, as a share of its length, is a line drawn forth and back: what width it has is rounding.
constexpr double kThinnest = 1e-12;

void check_outline(const std::vector<glm::dvec2>& outline) {
  check_loop(outline.size(), "contour");
  glm::dvec2 across{0.0};  // from the first point to the farthest
  for (const glm::dvec2& p : outline) {
    if (glm::length(p - outline.front()) > glm::length(across)) across = p - outline.front();
  }
  double width = 0;
  for (const glm::dvec2& p : outline) {
    const glm::dvec2 d = p - outline.front();
    width = std::max(width, std::abs(across.x * d.y - across.y * d.x));
  }
  if (!(width > kThinnest * glm::dot(across, across))) {
    throw InputError(
        "closed contour lies on one straight line and encloses nothing; open it or move a point aside");
  }
}

}  // namespace

double crease_cosine(double crease_deg) {
  if (!(crease_deg >= 0 && crease_deg <= 180)) {
    throw InputError("crease_deg needs to be 0 to 180, got " + number_text(crease_deg));
  }
  return cos_sin_deg(crease_deg).cos;
}

double reach_of(const Section& section) {
  double reach = 0;
  for (const SectionPoint& point : section.points) reach = std::max(reach, glm::length(point.position));
  return reach;
}

std::vector<glm::dvec2> outline_of(const Section& section) {
  std::vector<glm::dvec2> outline(section.points.size() - 1);
  for (std::size_t i = 0; i < outline.size(); ++i) outline[i] = section.points[i].position;
  return outline;
}

bool is_drawn_backwards(const Curve2& contour, const std::vector<Station>& stations, bool is_hole) {
  if (!contour.is_closed()) return false;
  std::vector<glm::dvec2> outline(stations.size() - 1);
  for (std::size_t i = 0; i < outline.size(); ++i) outline[i] = contour.evaluate(stations[i].out).position;
  check_outline(outline);
  return (twice_signed_area(outline) < 0) != is_hole;
}

Section make_section(const Curve2& contour, int cells, const SectionOptions& options) {
  std::vector<Station> stations = place_stations(contour, cells);
  if (!is_drawn_backwards(contour, stations, options.is_hole)) {
    return make_section(contour, stations, 1, options);
  }
  return make_section(contour, reversed(contour, std::move(stations)), -1, options);
}

Section make_section(const Curve2& contour, const std::vector<Station>& stations, double direction,
                     const SectionOptions& options) {
  Section section;
  section.is_closed = contour.is_closed();
  section.fractions = texture_fractions(stations, options.by);
  section.points.reserve(stations.size());
  const double crease_cos = crease_cosine(options.crease_deg);
  for (const Station& station : stations) {
    SectionPoint point{contour.evaluate(station.out).position, direction * contour.tangent(station.in),
                       direction * contour.tangent(station.out)};
    const glm::dvec2 both = point.tangent_in + point.tangent_out;
    // A contour that turns right back has no direction between: it breaks whatever the crease angle.
    const bool breaks = station.is_corner && (glm::dot(point.tangent_in, point.tangent_out) < crease_cos ||
                                              glm::length(both) < 1e-6);
    if (station.is_corner && !breaks) {
      point.tangent_in = point.tangent_out = glm::normalize(both);
    } else if (!station.is_corner) {
      point.tangent_in = point.tangent_out;
    }
    section.points.push_back(point);
    section.breaks.push_back(breaks);
    section.corners.push_back(station.is_corner);
  }
  // One place, the same bits.
  if (section.is_closed) section.points.back() = section.points.front();
  return section;
}

}  // namespace sweepkit::sweep
