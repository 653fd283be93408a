// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/right_triangle.hpp"

namespace sweepkit::texmap {

/// A triangle of the model, T1 of the paper's Fig. 2.
template <class Real>
struct Triangle3 {
  glm::vec<3, Real> a, b, c;
};

/// The stable map, the default: barycentric coordinates as ratios of areas in the plane that drops the
/// normal's dominant axis, and B2 + c |B2C2| along u + a |B2A2| along v. It is the same affine map as the
/// paper's (facts: two cevian ratios fix the barycentric coordinates), without its 0/0 at the hypotenuse. A
/// triangle without area maps to B2.
template <class Real>
glm::vec<2, Real> area_ratio_map(const Triangle3<Real>& triangle, const RightTriangle& right,
                                 const glm::vec<3, Real>& hit);

/// The same where the barycentric coordinates (a, b, c) of the hit are known already, as a ray tracer's are.
glm::dvec2 barycentric_map(const RightTriangle& right, double a, double c);

}  // namespace sweepkit::texmap
