// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/area_ratio_mapping.hpp"
#include "sweepkit/texmap/right_triangle.hpp"

namespace sweepkit::texmap {

/// The paper's map [Akdemir98, eq. 5-11], its choice of plane and its special cases (H1 = A1, H1 on A1C1)
/// kept as they are, for comparison: near the hypotenuse eq. 9 tends to 0/0 and the result may be NaN. Use
/// area_ratio_map().
template <class Real>
glm::vec<2, Real> cevian_map(const Triangle3<Real>& triangle, const RightTriangle& right,
                             const glm::vec<3, Real>& hit);

}  // namespace sweepkit::texmap
