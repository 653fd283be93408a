// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/number_type.hpp"
#include "sweepkit/texmap/right_triangle.hpp"
#include "sweepkit/texmap/triangle_map.hpp"

// Based on the inverse map of a convex quadrilateral [Haines91] with its last vertex doubled, [Akdemir98,
// section 2.1.2]. Kept for comparison.
//
// The quadrilateral is P(s, t) = Pd + s Pb + t Pc + s t Pa with corners Pd = B1 at (0,0), C1 at (1,0) and A1
// at both (1,1) and (0,1), so Pb = C1 - B1, Pc = A1 - B1, Pa = B1 - C1 + A1 - A1 = -Pb; Pn its normal. A
// point R lies on the line of constant s through Pd + s Pb along Pc + s Pa, so ((R - Pd - s Pb) x (Pc + s
// Pa)) . Pn = 0, a quadratic in s. With N_k = P_k x Pn:
//   Nb = Pb x Pn, Na = -Nb, Nc = Pc x Pn
//   s: Na . Pb vanishes, what is left is linear: s = (Nc . R - Ds0) / (Ds1 - Na . R),
//      Ds0 = Nc . Pd, Ds1 = Na . Pd + Nc . Pb
//   t: t^2 - 2 Ka t + Kb = 0, Ka = (Na . R - Dt1) / (2 Dt2), Kb = (Dt0 - Nb . R) / Dt2,
//      Dt0 = Nb . Pd, Dt1 = Na . Pd + Nb . Pc, Dt2 = Na . Pc
// The roots are t and, all along the doubled vertex, 1; Haines' root is the lesser, Ka - sqrt(Ka^2 - Kb).
// (u,v) is (s,t) over the whole cell of the texture: this map is not affine and does not keep the centroid,
// which comes to (1/2, 1/3) of the legs. The paper counts 17 numbers; since the doubled vertex fixes which
// equation is linear, 16 do.
//
// Fails: at A1 s is 0/0 and t the square root of a rounding error, NaN where that is negative, with half the
// digits lost near by; whole coordinates are multiplied, so distance from the origin costs digits too; N has
// the third power of the triangle's size, and D the fourth, so float overflows at 1e10 and underflows at
// 1e-10. A triangle without area is divided by 0.

namespace sweepkit::texmap {

struct DoubledVertexMap {
  static constexpr std::string_view kName = "doubled-vertex";

  template <class Real>
  struct Prepared {
    glm::vec<3, Real> na, nc;  ///< of s
    Real ds1, ds0;
    glm::vec<3, Real> na_half, nb;  ///< of t: Na / (2 Dt2) and Nb / Dt2
    Real dt1_half, dt0;             ///< Dt1 / (2 Dt2) and Dt0 / Dt2
  };

  template <class Real>
  static Real dot(const glm::vec<3, Real>& p, const glm::vec<3, Real>& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
  }

  template <class Real>
  static Prepared<Real> prepare(const Triangle3<Real>& t1, const RightTriangle& /*t2*/) {
    using Vec = glm::vec<3, Real>;
    const auto cross = [](const Vec& p, const Vec& q) {
      return Vec(p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x);
    };
    const Vec pb = t1.c - t1.b;
    const Vec pc = t1.a - t1.b;
    const Vec pn = cross(pb, pc);
    const Vec nb = cross(pb, pn);
    const Vec na = -nb;
    const Vec nc = cross(pc, pn);
    const Real dt2 = dot(na, pc);
    const Real dt1 = dot(na, t1.b) + dot(nb, pc);
    return {.na = na,
            .nc = nc,
            .ds1 = dot(na, t1.b) + dot(nc, pb),
            .ds0 = dot(nc, t1.b),
            .na_half = na / (dt2 + dt2),
            .nb = nb / dt2,
            .dt1_half = dt1 / (dt2 + dt2),
            .dt0 = dot(nb, t1.b) / dt2};
  }

  template <class Real>
  static glm::vec<2, Real> map(const Prepared<Real>& k, const Triangle3<Real>& /*t1*/,
                               const RightTriangle& t2, const glm::vec<3, Real>& hit) {
    const Real s = (dot(k.nc, hit) - k.ds0) / (k.ds1 - dot(k.na, hit));
    const Real ka = dot(k.na_half, hit) - k.dt1_half;
    const Real kb = k.dt0 - dot(k.nb, hit);
    const Real t = ka - square_root(ka * ka - kb);
    return {static_cast<Real>(t2.b.x) + s * static_cast<Real>(t2.bc),
            static_cast<Real>(t2.b.y) + t * static_cast<Real>(t2.ba)};
  }
};

}  // namespace sweepkit::texmap
