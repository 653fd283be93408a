// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/right_triangle.hpp"
#include "sweepkit/texmap/triangle_map.hpp"

// Based on [Heckbert86] as [Akdemir98, eq. 3-4] has it: (x, y, z) is a 3x3 matrix times (u, v, 1), and (u, v,
// 1) its inverse times (x, y, z). Departs from the paper in keeping two rows of the inverse, 6 numbers for
// its 9: the third gives 1 for every hit and is not looked at. Kept for comparison.
//
// Fails: the matrix has no inverse where the triangle's plane passes through the origin, as every floor at y
// = 0 does, and loses digits where it passes near; a hit off the plane is moved onto it along the line to the
// origin, however flat that line falls on it.

namespace sweepkit::texmap {

struct MatrixMap {
  static constexpr std::string_view kName = "matrix";

  template <class Real>
  struct Prepared {
    glm::vec<3, Real> u, v;  ///< rows (a, b, c) and (d, e, f) of eq. 4
  };

  template <class Real>
  static Prepared<Real> prepare(const Triangle3<Real>& t1, const RightTriangle& t2) {
    using Vec = glm::vec<3, Real>;
    const auto cross = [](const Vec& p, const Vec& q) {
      return Vec(p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x);
    };
    // Columns of eq. 3: along u, along v, and the place of (u,v) = (0,0).
    const Vec along_u = (t1.c - t1.b) / static_cast<Real>(t2.bc);
    const Vec along_v = (t1.a - t1.b) / static_cast<Real>(t2.ba);
    const Vec origin = t1.b - along_u * static_cast<Real>(t2.b.x) - along_v * static_cast<Real>(t2.b.y);
    const Vec u = cross(along_v, origin);
    const Real determinant = along_u.x * u.x + along_u.y * u.y + along_u.z * u.z;
    return {u / determinant, cross(origin, along_u) / determinant};
  }

  template <class Real>
  static glm::vec<2, Real> map(const Prepared<Real>& prepared, const Triangle3<Real>& /*t1*/,
                               const RightTriangle& /*t2*/, const glm::vec<3, Real>& hit) {
    const auto& [u, v] = prepared;
    return {u.x * hit.x + u.y * hit.y + u.z * hit.z, v.x * hit.x + v.y * hit.y + v.z * hit.z};
  }
};

}  // namespace sweepkit::texmap
