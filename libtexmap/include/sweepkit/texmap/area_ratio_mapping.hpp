// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/right_triangle.hpp"

// Based on the map of [Akdemir98, section 2.2], which two cevian ratios fix: with barycentric coordinates (a,
// b, c) of H1 for (A1, B1, C1), r_BC = c / (b + c) and r_BA = a / (a + b), so eq. 9 is |B2Y| = c |B2C2| and
// the map is affine. Departs from the paper in taking a and c as ratios of areas, without the 0/0 of eq. 9 on
// the hypotenuse (b = 0), and in the plane it works in: the one that drops the dominant axis of the normal,
// which no triangle is edge-on to.

namespace sweepkit::texmap {

/// A triangle of the model, T1 of the paper's Fig. 2.
template <class Real>
struct Triangle3 {
  glm::vec<3, Real> a, b, c;
};

/// (u, v) of H1 by areas. 10 multiplications and divisions a hit besides the choice of plane, which belongs
/// to the triangle. Differences are taken about B1, so neither distance from the origin nor a plane through
/// it matters. A triangle without area maps to B2.
template <class Real>
glm::vec<2, Real> area_ratio_map(const Triangle3<Real>& triangle, const RightTriangle& right,
                                 const glm::vec<3, Real>& hit) {
  const auto ba = triangle.a - triangle.b;
  const auto bc = triangle.c - triangle.b;
  const auto bh = hit - triangle.b;
  const Real nx = ba.y * bc.z - ba.z * bc.y;
  const Real ny = ba.z * bc.x - ba.x * bc.z;
  const Real nz = ba.x * bc.y - ba.y * bc.x;
  const auto size = [](Real value) { return value < 0 ? -value : value; };
  int i = 0;
  int j = 1;
  Real whole = nz;
  if (size(nx) >= size(ny) && size(nx) >= size(nz)) {
    i = 1;
    j = 2;
    whole = nx;
  } else if (size(ny) >= size(nz)) {
    i = 2;
    j = 0;
    whole = ny;
  }
  const glm::vec<2, Real> corner(static_cast<Real>(right.b.x), static_cast<Real>(right.b.y));
  if (whole == 0) return corner;
  const Real a = (bh[i] * bc[j] - bh[j] * bc[i]) / whole;
  const Real c = (ba[i] * bh[j] - ba[j] * bh[i]) / whole;
  return {corner.x + c * static_cast<Real>(right.bc), corner.y + a * static_cast<Real>(right.ba)};
}

/// The same where the barycentric coordinates a and c of the hit are known already, as a ray tracer's are.
inline glm::dvec2 barycentric_map(const RightTriangle& right, double a, double c) {
  return {right.b.x + c * right.bc, right.b.y + a * right.ba};
}

}  // namespace sweepkit::texmap
