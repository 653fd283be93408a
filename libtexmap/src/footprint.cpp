// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/footprint.hpp"

#include <cmath>

namespace sweepkit::texmap {
namespace {

// The nearest of the places that are the same one: a step over the seam is a small step. Only a whole period
// is taken off, so a box that is wide for a good reason stays wide.
double nearest(double at, double hit, double period) {
  // Most are: no step then is longer than half a period.
  const bool is_nearest = !(period > 0) || std::abs(at - hit) <= 0.5 * period;
  return is_nearest ? at : at - period * std::nearbyint((at - hit) / period);
}
glm::dvec2 nearest(glm::dvec2 uv, glm::dvec2 hit, glm::dvec2 period) {
  return {nearest(uv.x, hit.x, period.x), nearest(uv.y, hit.y, period.y)};
}

}  // namespace

UvBox neighbour_box(glm::dvec2 hit, std::span<const glm::dvec2> neighbours, glm::dvec2 period) {
  UvBox box{hit, hit};
  for (const glm::dvec2& neighbour : neighbours) {
    const glm::dvec2 uv = nearest(neighbour, hit, period);
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) continue;
    box.min = glm::min(box.min, uv);
    box.max = glm::max(box.max, uv);
  }
  return box;
}

UvBox shrunk(const UvBox& box, glm::dvec2 hit, double share) {
  return {hit + share * (box.min - hit), hit + share * (box.max - hit)};
}

std::optional<Footprint> footprint_from(glm::dvec2 hit, const Beside& beside, glm::dvec2 period) {
  const auto difference = [&](const std::optional<glm::dvec2>& before,
                              const std::optional<glm::dvec2>& after) -> std::optional<glm::dvec2> {
    if (before && after) return 0.5 * (nearest(*after, hit, period) - nearest(*before, hit, period));
    if (before) return hit - nearest(*before, hit, period);
    if (after) return nearest(*after, hit, period) - hit;
    return std::nullopt;
  };
  const auto dx = difference(beside.left, beside.right);
  const auto dy = difference(beside.above, beside.below);
  if (!dx || !dy) return std::nullopt;
  return Footprint{hit, *dx, *dy};
}

int cut_along_major(const Footprint& footprint, int most, std::span<FootprintPart> parts) {
  // On the screen the major axis lies along the eigenvector of J^T J = (a c; c b), J = (dx dy).
  const double a = glm::dot(footprint.dx, footprint.dx);
  const double b = glm::dot(footprint.dy, footprint.dy);
  const double c = glm::dot(footprint.dx, footprint.dy);
  const double half_difference = 0.5 * std::hypot(a - b, 2 * c);
  const double major = 0.5 * (a + b) + half_difference;
  const double minor = 0.5 * (a + b) - half_difference;
  parts[0] = {footprint, 1};
  const double aspect = minor > 0 ? std::sqrt(major / minor) : major;
  if (!std::isfinite(aspect) || !(half_difference > 0)) return 1;
  const int count = minor > 0 ? static_cast<int>(std::min<double>(most, std::ceil(aspect - 0.5))) : most;
  if (count < 2) return 1;
  const double angle = 0.5 * std::atan2(2 * c, a - b);
  const glm::dvec2 axis(std::cos(angle), std::sin(angle));
  const glm::dvec2 along = axis.x * footprint.dx + axis.y * footprint.dy;

  // Places t over the tent's two pixels, evenly; then drawn together so that the variance of the places,
  // and 1 / count^2 of the tent's for each part, make the tent's 1/6.
  const auto place = [&](int i) { return (2.0 * i + 1) / count - 1; };
  double weights = 0;
  double squares = 0;
  for (int i = 0; i < count; ++i) {
    const double weight = 1 - std::abs(place(i));
    weights += weight;
    squares += weight * place(i) * place(i);
  }
  const double share = 1.0 / count;
  const double spread = std::sqrt((1 - share * share) / 6 / (squares / weights));
  for (int i = 0; i < count; ++i) {
    parts[static_cast<std::size_t>(i)] = {
        {footprint.uv + spread * place(i) * along, footprint.dx - (1 - share) * axis.x * along,
         footprint.dy - (1 - share) * axis.y * along},
        (1 - std::abs(place(i))) / weights};
  }
  return count;
}

Footprint footprint_from(const Triangle3<double>& triangle, const std::array<glm::dvec2, 3>& uv,
                         glm::dvec2 hit, const glm::dvec3& dx, const glm::dvec3& dy) {
  // With B at the origin a step is a place, and the map of a unit right triangle tells its ratios (c, a).
  const Triangle3<double> about_b{triangle.a - triangle.b, glm::dvec3(0.0), triangle.c - triangle.b};
  constexpr RightTriangle kUnit{glm::dvec2(0.0), 1, 1};
  const auto step = [&](const glm::dvec3& moved) {
    const glm::dvec2 ratios = area_ratio_map(about_b, kUnit, moved);
    return ratios.x * (uv[2] - uv[1]) + ratios.y * (uv[0] - uv[1]);
  };
  return {hit, step(dx), step(dy)};
}

}  // namespace sweepkit::texmap
