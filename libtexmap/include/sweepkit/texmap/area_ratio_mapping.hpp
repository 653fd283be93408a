// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <type_traits>

#include "sweepkit/texmap/dominant_plane.hpp"
#include "sweepkit/texmap/right_triangle.hpp"
#include "sweepkit/texmap/triangle_map.hpp"

// Based on the map of [Akdemir98, section 2.2], which two cevian ratios fix: with barycentric coordinates (a,
// b, c) of H1 for (A1, B1, C1), r_BC = c / (b + c) and r_BA = a / (a + b), so eq. 9 is |B2Y| = c |B2C2| and
// the map is affine. Departs from the paper in taking a and c as ratios of areas, without the 0/0 of eq. 9 on
// the hypotenuse (b = 0), and in the plane it works in: the one that drops the dominant axis of the normal,
// which no triangle is edge-on to. Differences are taken about B1, so neither distance from the origin nor a
// plane through it matters.
//
// The default map. For every triangle and hit its error is below 8 epsilon times the conditioning times
// the leg (4 unless the area is lost in its rounding), and the last rounding of (u,v); the conditioning of
// c is (sum of |products| in the hit's area + |c| * sum of |products| in the whole area) / |whole area|,
// of a likewise (docs/algorithms/triangle-maps.md). A triangle without area maps to B2. Preconditions:
// finite coordinates; for double, edges and heights between 1e-100 and 1e140. float is computed in double,
// where products of its differences neither overflow nor vanish.

namespace sweepkit::texmap {
namespace area_ratio {

template <class Real>
using Working = std::conditional_t<std::is_same_v<Real, float>, double, Real>;

template <class Real>
Triangle3<Working<Real>> widened(const Triangle3<Real>& t1) {
  using Wide = glm::vec<3, Working<Real>>;
  return {Wide(t1.a), Wide(t1.b), Wide(t1.c)};
}

// Twice the signed area of (o, p, q).
template <class Real>
Real cross(const glm::vec<2, Real>& op, const glm::vec<2, Real>& oq) {
  return op.x * oq.y - op.y * oq.x;
}

}  // namespace area_ratio

/// (u,v) of a hit whose barycentric coordinates a and c for (A1, B1, C1) are known already, as a ray tracer's
/// are. 2 multiplications.
inline glm::dvec2 area_ratio_map(const RightTriangle& t2, double a, double c) {
  return {t2.b.x + c * t2.bc, t2.b.y + a * t2.ba};
}

/// (u,v) of a hit on a triangle of which nothing is kept: 15 multiplications and divisions, the choice of
/// plane included.
template <class Real>
glm::vec<2, Real> area_ratio_map(const Triangle3<Real>& t1, const RightTriangle& t2,
                                 const glm::vec<3, Real>& hit) {
  using Wide = area_ratio::Working<Real>;
  const Triangle3<Wide> wide = area_ratio::widened(t1);
  const DominantPlane<Wide> plane = dominant_plane(wide);
  const glm::vec<3, Wide> from_b = glm::vec<3, Wide>(hit) - wide.b;
  const glm::vec<2, Wide> bh(from_b[plane.i], from_b[plane.j]);
  const bool has_area = plane.area2 != 0;
  const Wide c = has_area ? area_ratio::cross(plane.ba, bh) / plane.area2 : Wide(0);
  const Wide a = has_area ? area_ratio::cross(bh, plane.bc) / plane.area2 : Wide(0);
  return {static_cast<Real>(static_cast<Wide>(t2.b.x) + c * static_cast<Wide>(t2.bc)),
          static_cast<Real>(static_cast<Wide>(t2.b.y) + a * static_cast<Wide>(t2.ba))};
}

/// The same where the divisions are done beforehand: 6 multiplications for a hit.
struct AreaRatioMap {
  static constexpr std::string_view kName = "area-ratio";

  template <class Real>
  struct Prepared {
    glm::vec<2, area_ratio::Working<Real>> ba, bc;  ///< over twice the area; 0 where there is none
    int i, j;                                       ///< the axes they are in
  };

  template <class Real>
  static Prepared<Real> prepare(const Triangle3<Real>& t1, const RightTriangle& /*t2*/) {
    const auto plane = dominant_plane(area_ratio::widened(t1));
    if (plane.area2 == 0) return {{0, 0}, {0, 0}, plane.i, plane.j};
    return {plane.ba / plane.area2, plane.bc / plane.area2, plane.i, plane.j};
  }

  template <class Real>
  static glm::vec<2, Real> map(const Prepared<Real>& prepared, const Triangle3<Real>& t1,
                               const RightTriangle& t2, const glm::vec<3, Real>& hit) {
    using Wide = area_ratio::Working<Real>;
    const glm::vec<2, Wide> bh(static_cast<Wide>(hit[prepared.i]) - static_cast<Wide>(t1.b[prepared.i]),
                               static_cast<Wide>(hit[prepared.j]) - static_cast<Wide>(t1.b[prepared.j]));
    const Wide c = area_ratio::cross(prepared.ba, bh);
    const Wide a = area_ratio::cross(bh, prepared.bc);
    return {static_cast<Real>(static_cast<Wide>(t2.b.x) + c * static_cast<Wide>(t2.bc)),
            static_cast<Real>(static_cast<Wide>(t2.b.y) + a * static_cast<Wide>(t2.ba))};
  }
};

}  // namespace sweepkit::texmap
