// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/dominant_plane.hpp"
#include "sweepkit/texmap/right_triangle.hpp"
#include "sweepkit/texmap/triangle_map.hpp"

// Based on [Akdemir98, eq. 1-2] after [Celniker91]: barycentric coordinates (L1, L2, L3) for (A1, B1, C1) by
// eq. 2, the inverse of the matrix of eq. 1 for the model's triangle in a plane, then (u,v) by eq. 1 for the
// texture's. The paper does not say which plane; here it is the one without the normal's dominant axis. Kept
// for comparison.
//
// Fails: the matrix holds products of whole coordinates, not of differences, so every digit that the distance
// from the origin adds to them is lost; a triangle without area is divided by 0.

namespace sweepkit::texmap {

struct BarycentricMap {
  static constexpr std::string_view kName = "barycentric";

  template <class Real>
  struct Prepared {
    glm::vec<3, Real> l1, l2, l3;  ///< the rows (a_k, b_k, c_k) of eq. 2
    int i, j;                      ///< the axes that stand for its u and v
  };

  template <class Real>
  static Prepared<Real> prepare(const Triangle3<Real>& t1, const RightTriangle& /*t2*/) {
    const auto plane = dominant_plane(t1);
    const auto flat = [&](const glm::vec<3, Real>& p) { return glm::vec<2, Real>(p[plane.i], p[plane.j]); };
    // The row of a corner's coordinate: the line through the other two, in homogeneous coordinates.
    const auto line = [](const glm::vec<2, Real>& p, const glm::vec<2, Real>& q) {
      return glm::vec<3, Real>(p.y - q.y, q.x - p.x, p.x * q.y - p.y * q.x);
    };
    const glm::vec<2, Real> a = flat(t1.a);
    const glm::vec<2, Real> b = flat(t1.b);
    const glm::vec<2, Real> c = flat(t1.c);
    const glm::vec<3, Real> l1 = line(b, c);
    const glm::vec<3, Real> l2 = line(c, a);
    const glm::vec<3, Real> l3 = line(a, b);
    const Real determinant = l1.z + l2.z + l3.z;
    return {l1 / determinant, l2 / determinant, l3 / determinant, plane.i, plane.j};
  }

  template <class Real>
  static glm::vec<2, Real> map(const Prepared<Real>& prepared, const Triangle3<Real>& /*t1*/,
                               const RightTriangle& t2, const glm::vec<3, Real>& hit) {
    const auto coordinate = [&](const glm::vec<3, Real>& row) {
      return row.x * hit[prepared.i] + row.y * hit[prepared.j] + row.z;
    };
    const Real l1 = coordinate(prepared.l1);
    const Real l2 = coordinate(prepared.l2);
    const Real l3 = coordinate(prepared.l3);
    const glm::vec<2, Real> b2(static_cast<Real>(t2.b.x), static_cast<Real>(t2.b.y));
    const Real u3 = static_cast<Real>(t2.b.x + t2.bc);
    const Real v1 = static_cast<Real>(t2.b.y + t2.ba);
    return {b2.x * l1 + b2.x * l2 + u3 * l3, v1 * l1 + b2.y * l2 + b2.y * l3};
  }
};

}  // namespace sweepkit::texmap
