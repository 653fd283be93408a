// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "stability/map_calls.hpp"

namespace sweepkit::report {

glm::dvec2 map_by_area_ratio(const texmap::Triangle3<double>& t1, const texmap::RightTriangle& t2,
                             const glm::dvec3& hit) {
  return texmap::map_once<texmap::AreaRatioMap>(t1, t2, hit);
}

glm::vec2 map_by_area_ratio(const texmap::Triangle3<float>& t1, const texmap::RightTriangle& t2,
                            const glm::vec3& hit) {
  return texmap::map_once<texmap::AreaRatioMap>(t1, t2, hit);
}

glm::dvec2 map_by_barycentric(const texmap::Triangle3<double>& t1, const texmap::RightTriangle& t2,
                              const glm::dvec3& hit) {
  return texmap::map_once<texmap::BarycentricMap>(t1, t2, hit);
}

}  // namespace sweepkit::report
