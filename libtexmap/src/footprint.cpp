// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/footprint.hpp"

#include <cmath>

namespace sweepkit::texmap {
namespace {

// The nearest of the places that are the same one: a step over the seam is a small step. Only a whole period
// is taken off, so a box that is wide for a good reason stays wide.
glm::dvec2 nearest(glm::dvec2 uv, glm::dvec2 hit, glm::dvec2 period) {
  if (period.x > 0) uv.x -= period.x * std::nearbyint((uv.x - hit.x) / period.x);
  if (period.y > 0) uv.y -= period.y * std::nearbyint((uv.y - hit.y) / period.y);
  return uv;
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
