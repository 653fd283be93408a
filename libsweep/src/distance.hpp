// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace sweepkit::sweep {

double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b);

/// A triangle of any shape, one without area too, that is asked for many points' distances.
class DistanceTriangle {
 public:
  DistanceTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

  double distance(const glm::dvec3& p) const;
  /// The distance from its plane of a point above or below it, infinity for any other: never less than
  /// distance(), and quicker.
  double distance_above(const glm::dvec3& p) const;

 private:
  glm::dvec3 a_, b_, c_;
  glm::dvec3 normal_;       // of length 1; 0 without area
  glm::dvec3 to_b_, to_c_;  // p - a times these are p's barycentric coordinates at b and c
};

/// The two triangles r p q and q s r of a cell of a grid.
class DistanceCell {
 public:
  DistanceCell(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const glm::dvec3& s)
      : first_(r, p, q), second_(q, s, r) {}

  /// The larger of `worst` and the distance of `point` from the nearer triangle.
  double worse(const glm::dvec3& point, double worst) const;

 private:
  DistanceTriangle first_, second_;
};

}  // namespace sweepkit::sweep
