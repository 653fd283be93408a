// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/number_type.hpp"
#include "sweepkit/texmap/triangle_map.hpp"

namespace sweepkit::texmap {

/// A triangle seen along the axis that its normal is longest in, which no triangle is edge-on to.
template <class Real>
struct DominantPlane {
  int i = 0;  ///< the axes that stay; (dropped, i, j) is (x, y, z) turned
  int j = 1;
  glm::vec<2, Real> ba, bc;  ///< from B1 to A1 and to C1
  Real area2 = 0;            ///< twice the signed area; 0 where rounding has left nothing of it
};

/// Never divides, so nothing here is infinite for coordinates up to the square root of the number type's
/// largest. An area below 4 epsilon times the products it is the difference of is taken for none
/// (docs/algorithms/triangle-maps.md says why), and so is one whose products are below 1e-290, where double
/// keeps no relative precision, or not finite.
template <class Real>
DominantPlane<Real> dominant_plane(const Triangle3<Real>& t1) {
  constexpr double kLeastProducts = 1e-290;
  const auto size = [](const Real& value) { return value < 0 ? -value : value; };
  const glm::vec<3, Real> ba = t1.a - t1.b;
  const glm::vec<3, Real> bc = t1.c - t1.b;
  const glm::vec<3, Real> plus(ba.y * bc.z, ba.z * bc.x, ba.x * bc.y);
  const glm::vec<3, Real> minus(ba.z * bc.y, ba.x * bc.z, ba.y * bc.x);
  const glm::vec<3, Real> normal = plus - minus;
  int dropped = 0;
  if (size(normal[1]) > size(normal[dropped])) dropped = 1;
  if (size(normal[2]) > size(normal[dropped])) dropped = 2;
  const int i = (dropped + 1) % 3;
  const int j = (dropped + 2) % 3;
  const Real products = size(plus[dropped]) + size(minus[dropped]);
  // Written so that NaN and infinity, too, are no area.
  const bool has_area =
      size(normal[dropped]) > static_cast<Real>(4 * kEpsilon<Real>) * products && products > kLeastProducts;
  return {i, j, {ba[i], ba[j]}, {bc[i], bc[j]}, has_area ? normal[dropped] : Real(0)};
}

}  // namespace sweepkit::texmap
