// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "voxel_grid.hpp"

namespace sweepkit::render {

/// Do a triangle and a box share a point? Separating axes (Akenine-Moller 2001): the triangle's plane and the
/// nine products of edges and axes; the boxes' own axes are the caller's, who knows that the bounding boxes
/// meet.
inline bool overlaps(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Box& box) {
  const glm::dvec3 middle = 0.5 * (box.low + box.high);
  const glm::dvec3 half = 0.5 * (box.high - box.low);
  const glm::dvec3 v[3] = {a - middle, b - middle, c - middle};
  const glm::dvec3 edge[3] = {v[1] - v[0], v[2] - v[1], v[0] - v[2]};
  const auto separates = [&](const glm::dvec3& axis) {
    const double p0 = glm::dot(v[0], axis);
    const double p1 = glm::dot(v[1], axis);
    const double p2 = glm::dot(v[2], axis);
    const double reach = glm::dot(half, glm::abs(axis));
    return std::min({p0, p1, p2}) > reach || std::max({p0, p1, p2}) < -reach;
  };
  if (separates(glm::cross(edge[0], edge[1]))) return false;
  for (const glm::dvec3& e : edge) {
    if (separates({0, -e.z, e.y}) || separates({e.z, 0, -e.x}) || separates({-e.y, e.x, 0})) return false;
  }
  return true;
}

}  // namespace sweepkit::render
