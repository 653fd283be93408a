// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sweepkit::sweep {

double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 way = b - a;
  const double length_squared = glm::dot(way, way);
  const double t = length_squared > 0 ? std::clamp(glm::dot(p - a, way) / length_squared, 0.0, 1.0) : 0;
  return glm::length(p - (a + t * way));
}

DistanceTriangle::DistanceTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    : a_(a), b_(b), c_(c), normal_(0.0), to_b_(0.0), to_c_(0.0) {
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const double n_squared = glm::dot(n, n);
  if (!(n_squared > 0)) return;
  normal_ = n / std::sqrt(n_squared);
  to_b_ = glm::cross(c - a, n) / n_squared;
  to_c_ = glm::cross(n, b - a) / n_squared;
}

double DistanceTriangle::distance_above(const glm::dvec3& p) const {
  const glm::dvec3 w = p - a_;
  const double at_b = glm::dot(w, to_b_);
  const double at_c = glm::dot(w, to_c_);
  const bool is_above = at_b >= 0 && at_c >= 0 && at_b + at_c <= 1 && normal_ != glm::dvec3(0.0);
  return is_above ? std::abs(glm::dot(w, normal_)) : std::numeric_limits<double>::infinity();
}

double DistanceTriangle::distance(const glm::dvec3& p) const {
  // Above the triangle its plane is nearest: a side may come out less by rounding.
  return std::min({distance_above(p), distance_to_segment(p, a_, b_), distance_to_segment(p, b_, c_),
                   distance_to_segment(p, c_, a_)});
}

double DistanceCell::worse(const glm::dvec3& point, double worst) const {
  if (first_.distance_above(point) <= worst || second_.distance_above(point) <= worst) return worst;
  return std::max(worst, std::min(first_.distance(point), second_.distance(point)));
}

}  // namespace sweepkit::sweep
