// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/primitives.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "number_text.hpp"
#include "sweepkit/error.hpp"
#include "whole_angle.hpp"

namespace sweepkit::sweep {
namespace {

void check_size(double size, const std::string& what) {
  if (!(size > 0) || !std::isfinite(size)) {
    throw InputError(what + " needs to be above 0 m, got " + number_text(size));
  }
}

void check_count(int count, int least, int most, const std::string& what) {
  if (count < least || count > most) {
    throw InputError(what + " needs to be " + std::to_string(least) + " to " + std::to_string(most) +
                     ", got " + std::to_string(count));
  }
}

glm::dvec2 on_circle(int part, int parts, double radius) {
  const auto [c, s] = cos_sin_turn(part, parts);
  return {radius * c, radius * s};
}

}  // namespace

Curve2 circle_contour(double radius) {
  check_size(radius, "radius");
  return Curve2({ArcSegment<2>{{0, 0}, {radius, 0}, {0, radius}, 0, 360}});
}

Curve2 ellipse_contour(double x_radius, double y_radius) {
  check_size(x_radius, "rx");
  check_size(y_radius, "ry");
  return Curve2({ArcSegment<2>{{0, 0}, {x_radius, 0}, {0, y_radius}, 0, 360}});
}

Curve2 rectangle_contour(double width, double height, double corner_radius) {
  check_size(width, "width");
  check_size(height, "height");
  const double most = std::min(width, height) / 2;
  if (!(corner_radius >= 0 && corner_radius <= most)) {
    throw InputError("corner_radius needs to be 0 m to half of the shorter side, " + number_text(most) +
                     " m, got " + number_text(corner_radius));
  }
  const double x = width / 2;
  const double y = height / 2;
  const double r = corner_radius;
  std::vector<Segment<2>> segments;
  glm::dvec2 at(x, 0);
  const auto line_to = [&](const glm::dvec2& to) {
    segments.push_back(BezierSegment<2>{{at, to}});
    at = to;
  };
  const auto corner = [&](double corner_x, double corner_y, double from_deg) {
    const auto [c, s] = cos_sin_deg(from_deg);
    const glm::dvec2 center(corner_x - std::copysign(r, corner_x), corner_y - std::copysign(r, corner_y));
    line_to(center + r * glm::dvec2(c, s));
    if (r > 0) segments.push_back(ArcSegment<2>{center, {r, 0}, {0, r}, from_deg, from_deg + 90});
    at = center + r * glm::dvec2(-s, c);
  };
  corner(x, y, 0);
  corner(-x, y, 90);
  corner(-x, -y, 180);
  corner(x, -y, 270);
  line_to({x, 0});
  return Curve2(std::move(segments));
}

Curve2 polygon_contour(int sides, double radius) {
  check_count(sides, 3, 4096, "sides");
  check_size(radius, "radius");
  std::vector<glm::dvec2> corners;
  corners.reserve(static_cast<std::size_t>(sides));
  for (int i = 0; i < sides; ++i) corners.push_back(on_circle(i, sides, radius));
  return polyline<2>(corners, true);
}

Curve2 star_contour(int points, double radius, double inner_radius) {
  check_count(points, 2, 2048, "points");
  check_size(radius, "radius");
  check_size(inner_radius, "inner_radius");
  std::vector<glm::dvec2> corners;
  corners.reserve(2 * static_cast<std::size_t>(points));
  for (int i = 0; i < 2 * points; ++i)
    corners.push_back(on_circle(i, 2 * points, i % 2 == 0 ? radius : inner_radius));
  return polyline<2>(corners, true);
}

Curve2 arc_contour(double radius, double from_deg, double to_deg) {
  check_size(radius, "radius");
  const double turn = std::abs(to_deg - from_deg);
  if (!(turn > 0 && turn <= 360)) {
    throw InputError("arc needs angles that differ by at most 360 degrees, and not by 0, got " +
                     number_text(from_deg) + " and " + number_text(to_deg));
  }
  return Curve2({ArcSegment<2>{{0, 0}, {radius, 0}, {0, radius}, from_deg, to_deg}});
}

Curve3 laid_flat(const Curve2& curve) {
  const auto flat = [](const glm::dvec2& p) { return glm::dvec3(p.x, 0, 0.0 - p.y); };
  std::vector<Segment<3>> segments;
  for (const Segment<2>& segment : curve.segments()) {
    if (const auto* bezier = std::get_if<BezierSegment<2>>(&segment)) {
      BezierSegment<3> laid;
      for (const glm::dvec2& p : bezier->control) laid.control.push_back(flat(p));
      segments.emplace_back(std::move(laid));
    } else {
      const auto& arc = std::get<ArcSegment<2>>(segment);
      segments.emplace_back(ArcSegment<3>{flat(arc.center), flat(arc.x_axis), flat(arc.y_axis), arc.from_deg,
                                          arc.to_deg, flat(arc.rise)});
    }
  }
  return Curve3(std::move(segments));
}

Curve3 circle_trajectory(double radius) {
  return laid_flat(circle_contour(radius));
}

Curve3 helix(double radius, double pitch, double turns) {
  check_size(radius, "radius");
  if (!std::isfinite(pitch)) throw InputError("pitch needs to be a finite number");
  if (!(turns > 0 && turns <= 1e6)) {
    throw InputError("turns needs to be above 0 and at most a million, got " + number_text(turns));
  }
  return Curve3(
      {ArcSegment<3>{{0, 0, 0}, {radius, 0, 0}, {0, 0, -radius}, 0, 360 * turns, {0, pitch * turns, 0}}});
}

Curve3 torus_knot(int p, int q, double radius, double tube) {
  check_count(p, 1, 1000, "p");
  check_count(q, 1, 1000, "q");
  check_size(radius, "radius");
  check_size(tube, "tube");
  if (const int divisor = std::gcd(p, q); divisor > 1) {
    throw InputError("p and q share the divisor " + std::to_string(divisor) +
                     ", so the knot would run along itself; choose two that share none");
  }
  if (!(tube < radius)) {
    throw InputError("tube needs to be below radius, or the knot runs through its axis; got " +
                     number_text(tube) + " and " + number_text(radius));
  }
  return Curve3({TorusKnotSegment{p, q, radius, tube}});
}

}  // namespace sweepkit::sweep
