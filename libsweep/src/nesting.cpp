// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "nesting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "stations.hpp"
#include "sweepkit/error.hpp"
#include "triangulate.hpp"

namespace sweepkit::sweep {
namespace {

// Enough to tell inside from outside for outlines that do not touch.
constexpr int kCells = 128;

struct Polygon {
  std::vector<glm::dvec2> points;
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};
  double area = 0;
};

Polygon polygon_of(const Curve2& outline) {
  const std::vector<Station> stations = place_stations(outline, kCells);
  Polygon polygon;
  polygon.points.reserve(stations.size());
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    const glm::dvec2 p = outline.evaluate(stations[i].out).position;
    polygon.points.push_back(p);
    polygon.low = glm::min(polygon.low, p);
    polygon.high = glm::max(polygon.high, p);
  }
  polygon.area = std::abs(twice_signed_area(polygon.points));
  return polygon;
}

// By the edges that a ray towards +x crosses.
bool holds(const Polygon& polygon, const glm::dvec2& p) {
  if (p.x < polygon.low.x || p.y < polygon.low.y || p.x > polygon.high.x || p.y > polygon.high.y)
    return false;
  bool is_inside = false;
  for (std::size_t i = 0, j = polygon.points.size() - 1; i < polygon.points.size(); j = i++) {
    const glm::dvec2& a = polygon.points[i];
    const glm::dvec2& b = polygon.points[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
      is_inside = !is_inside;
  }
  return is_inside;
}

// All of it: where outlines touch, a few vertices may seem to lie on either side.
bool holds(const Polygon& outer, const Polygon& inner) {
  if (inner.area >= outer.area) return false;
  const auto inside = std::count_if(inner.points.begin(), inner.points.end(),
                                    [&](const glm::dvec2& p) { return holds(outer, p); });
  return 10 * static_cast<std::size_t>(inside) >= 9 * inner.points.size();
}

}  // namespace

std::vector<std::size_t> nest_outlines(std::span<const Curve2> outlines) {
  if (outlines.empty()) throw InputError("contour needs at least one outline");
  if (outlines.size() == 1) return {0};
  std::vector<Polygon> polygons;
  polygons.reserve(outlines.size());
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (!outlines[i].is_closed()) {
      throw InputError("contour has " + std::to_string(outlines.size()) + " outlines, and outline " +
                       std::to_string(i) + " is open; close it, or sweep it alone");
    }
    polygons.push_back(polygon_of(outlines[i]));
  }
  std::vector<std::size_t> outer(outlines.size());
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    std::size_t depth = 0;
    std::size_t nearest = i;  // the smallest that holds it
    for (std::size_t j = 0; j < outlines.size(); ++j) {
      if (j == i || !holds(polygons[j], polygons[i])) continue;
      ++depth;
      if (nearest == i || polygons[j].area < polygons[nearest].area) nearest = j;
    }
    outer[i] = depth % 2 == 1 ? nearest : i;
  }
  return outer;
}

}  // namespace sweepkit::sweep
