// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/texmap/triangle_maps.hpp"

namespace sweepkit::report {

/// The maps, which are templates in headers, each called from one place: so a test can compile them otherwise
/// than what judges them.
glm::dvec2 map_by_area_ratio(const texmap::Triangle3<double>& t1, const texmap::RightTriangle& t2,
                             const glm::dvec3& hit);
/// In float32 corners and hit, which the map computes in double.
glm::vec2 map_by_area_ratio(const texmap::Triangle3<float>& t1, const texmap::RightTriangle& t2,
                            const glm::vec3& hit);
/// The barycentric matrix of whole coordinates, in double: the textbook's.
glm::dvec2 map_by_barycentric(const texmap::Triangle3<double>& t1, const texmap::RightTriangle& t2,
                              const glm::dvec3& hit);

}  // namespace sweepkit::report
