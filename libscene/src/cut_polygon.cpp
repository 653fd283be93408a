// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Ears are cut off one after another [Meisters 1975, Polygons have ears], in the plane of the polygon's own
// mean normal [Newell 1972]: an ear is a convex corner whose triangle holds no other corner. Of the ears the
// one with the shortest cut goes first, so that triangles do not grow long.

#include "cut_polygon.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace sweepkit::scene {
namespace {

double twice_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The corners in the plane across the mean normal, counter-clockwise: without its dominant axis.
std::vector<glm::dvec2> flattened(std::span<const glm::dvec3> corners) {
  glm::dvec3 normal(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  const glm::dvec3 size = glm::abs(normal);
  const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::vector<glm::dvec2> flat;
  flat.reserve(corners.size());
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 p = corner - corners[0];
    const glm::dvec2 q(p[(axis + 1) % 3], p[(axis + 2) % 3]);
    flat.push_back(normal[axis] < 0 ? glm::dvec2(q.y, q.x) : q);
  }
  return flat;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> cut_polygon(std::span<const glm::dvec3> corners) {
  if (corners.size() == 3) return {{0, 1, 2}};
  const std::vector<glm::dvec2> flat = flattened(corners);
  std::vector<std::uint32_t> left(corners.size());
  std::iota(left.begin(), left.end(), 0u);
  const auto at = [&](std::size_t i) { return left[i % left.size()]; };
  const auto is_ear = [&](std::size_t i) {
    const std::uint32_t a = at(i + left.size() - 1);
    const std::uint32_t b = at(i);
    const std::uint32_t c = at(i + 1);
    if (!(twice_area(flat[a], flat[b], flat[c]) > 0)) return false;
    for (const std::uint32_t other : left) {
      if (other == a || other == b || other == c) continue;
      const glm::dvec2& p = flat[other];
      if (p == flat[a] || p == flat[b] || p == flat[c]) continue;
      if (twice_area(flat[a], flat[b], p) >= 0 && twice_area(flat[b], flat[c], p) >= 0 &&
          twice_area(flat[c], flat[a], p) >= 0) {
        return false;
      }
    }
    return true;
  };
  std::vector<std::array<std::uint32_t, 3>> triangles;
  // Long polygons: the first ear will do, since looking at all of them every time would take too long.
  constexpr std::size_t kFewCorners = 32;
  while (left.size() > 3) {
    std::size_t best = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < left.size(); ++i) {
      const double length = glm::distance(corners[at(i + left.size() - 1)], corners[at(i + 1)]);
      if (!(length < shortest) || !is_ear(i)) continue;
      shortest = length;
      best = i;
      if (left.size() > kFewCorners) break;
    }
    triangles.push_back({at(best + left.size() - 1), at(best), at(best + 1)});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace sweepkit::scene
