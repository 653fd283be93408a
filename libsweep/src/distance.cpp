// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "distance.hpp"

#include <algorithm>
#include <cmath>

namespace sweepkit::sweep {

double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 way = b - a;
  const double length_squared = glm::dot(way, way);
  const double t = length_squared > 0 ? std::clamp(glm::dot(p - a, way) / length_squared, 0.0, 1.0) : 0;
  return glm::length(p - (a + t * way));
}

double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                            const glm::dvec3& c) {
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const double n_squared = glm::dot(n, n);
  const glm::dvec3 w = p - a;
  if (n_squared > 0) {
    const double at_c = glm::dot(glm::cross(b - a, w), n) / n_squared;
    const double at_b = glm::dot(glm::cross(w, c - a), n) / n_squared;
    if (at_b >= 0 && at_c >= 0 && at_b + at_c <= 1) return std::abs(glm::dot(w, n)) / std::sqrt(n_squared);
  }
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

}  // namespace sweepkit::sweep
