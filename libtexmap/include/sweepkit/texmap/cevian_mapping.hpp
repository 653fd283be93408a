// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/right_triangle.hpp"
#include "sweepkit/texmap/triangle_map.hpp"

// Based on [Akdemir98, eq. 5-11], its choice of plane and its special cases (H1 = A1, H1 on A1C1) as they
// are. Kept for comparison.
//
// Symbols: H1 the hit, T1 = (A1, B1, C1) the model's triangle, T2 = (A2, B2, C2) the texture's; I_BC the
// point where the line from A1 through H1 meets B1C1, r_BC = |B1 I_BC| / |B1C1| (eq. 5), r_BA likewise on
// B1A1, r_AC on A1C1.
//
// Fails: near the hypotenuse, where both ratios tend to 1 and eq. 9 to 0/0, digits are lost as 1/b, b being
// B1's barycentric coordinate; a hit at C1 makes r_BA 0/0, as one at A1 makes r_BC; planes that contain the z
// direction without being an x- or y-plane (x = y, say) are seen edge-on, and eq. 8 is 0/0.

namespace sweepkit::texmap {
namespace cevian {

// Eq. 8: the share of edge from -> to (of its length, from `from`) where the line from `apex` through the hit
// meets it, in the plane of coordinates i and j.
template <class Real>
Real ratio(const glm::vec<3, Real>& apex, const glm::vec<3, Real>& from, const glm::vec<3, Real>& to,
           const glm::vec<3, Real>& hit, int i, int j) {
  const Real numerator = (hit[i] - apex[i]) * (to[j] - hit[j]) - (hit[j] - apex[j]) * (to[i] - hit[i]);
  const Real denominator = (hit[j] - apex[j]) * (from[i] - to[i]) - (hit[i] - apex[i]) * (from[j] - to[j]);
  return 1 - numerator / denominator;
}

}  // namespace cevian

struct CevianMap {
  static constexpr std::string_view kName = "cevian";

  template <class Real>
  struct Prepared {};

  template <class Real>
  static Prepared<Real> prepare(const Triangle3<Real>& /*t1*/, const RightTriangle& /*t2*/) {
    return {};
  }

  /// 15 multiplications and divisions; the paper's 16 form r_BC r_BA twice, once for each use of eq. 9.
  template <class Real>
  static glm::vec<2, Real> map(const Prepared<Real>& /*prepared*/, const Triangle3<Real>& t1,
                               const RightTriangle& t2, const glm::vec<3, Real>& hit) {
    const auto& [a1, b1, c1] = t1;
    const Real bc = static_cast<Real>(t2.bc);
    const Real ba = static_cast<Real>(t2.ba);
    const glm::vec<2, Real> b2(static_cast<Real>(t2.b.x), static_cast<Real>(t2.b.y));
    if (hit == a1) return {b2.x, b2.y + ba};

    // "If T1 is on the x-plane, the xs should be replaced with zs, and if T1 is on the y-plane, the ys".
    int i = 0;
    int j = 1;
    if (a1.x == b1.x && b1.x == c1.x) {
      i = 2;
    } else if (a1.y == b1.y && b1.y == c1.y) {
      j = 2;
    }
    const Real r_bc = cevian::ratio(a1, b1, c1, hit, i, j);
    const Real r_ba = cevian::ratio(c1, b1, a1, hit, i, j);
    if (r_bc == 1 && r_ba == 1) {  // on the hypotenuse: eq. 10-11
      const Real r_ac = cevian::ratio(b1, a1, c1, hit, i, j);
      return {b2.x + r_ac * bc, b2.y + (1 - r_ac) * ba};
    }
    const Real product = r_bc * r_ba;
    const Real along_u = (product - r_bc) / (product - 1);  // eq. 9
    const Real along_v = (product - r_ba) / (product - 1);
    return {b2.x + along_u * bc, b2.y + along_v * ba};
  }
};

}  // namespace sweepkit::texmap
