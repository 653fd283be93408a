// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/triangle_maps.hpp"

#include "sweepkit/strict_math.hpp"

#include <algorithm>
#include <cmath>

namespace sweepkit::texmap {
namespace {

template <class Map>
CentroidError centroid_error(const Triangle3<double>& t1, const RightTriangle& t2) {
  const glm::dvec3 from = (t1.a + t1.b + t1.c) / 3.0;
  const glm::dvec2 to = t2.b + glm::dvec2(t2.bc, t2.ba) / 3.0;
  return {Map::kName, glm::length(map_once<Map>(t1, t2, from) - to)};
}

template <class... Maps>
std::array<CentroidError, sizeof...(Maps)> errors_of(std::tuple<Maps...> /*methods*/,
                                                     const Triangle3<double>& t1, const RightTriangle& t2) {
  static_assert((TriangleMap<Maps, double> && ...) && (TriangleMap<Maps, float> && ...));
  return {centroid_error<Maps>(t1, t2)...};
}

}  // namespace

std::array<CentroidError, std::tuple_size_v<TriangleMaps>> centroid_errors(const Triangle3<double>& t1,
                                                                           const RightTriangle& t2) {
  return errors_of(TriangleMaps{}, t1, t2);
}

std::array<CentroidErrors, std::tuple_size_v<TriangleMaps>> summarize_centroid_errors(
    const MappedSurface& surface) {
  std::array<CentroidErrors, std::tuple_size_v<TriangleMaps>> all;
  std::size_t count = 0;
  for (const auto& [ia, ib, ic] : surface.triangles) {
    const glm::dvec2 a(surface.texcoords[ia]);
    const glm::dvec2 b(surface.texcoords[ib]);
    const glm::dvec2 c(surface.texcoords[ic]);
    if (a.x != b.x || c.y != b.y || a.y == b.y || c.x == b.x) continue;
    ++count;
    const RightTriangle t2 = right_triangle(a, b, c);
    const double leg = std::max(std::abs(t2.bc), std::abs(t2.ba));
    const auto errors = centroid_errors({glm::dvec3(surface.positions[ia]), glm::dvec3(surface.positions[ib]),
                                         glm::dvec3(surface.positions[ic])},
                                        t2);
    for (std::size_t k = 0; k < errors.size(); ++k) {
      const double error = errors[k].distance / leg;
      all[k].method = errors[k].method;
      if (!std::isfinite(error)) {
        ++all[k].failures;
        continue;
      }
      all[k].has_value = true;
      all[k].mean += error;
      all[k].worst = std::max(all[k].worst, error);
    }
  }
  for (CentroidErrors& errors : all) {
    if (errors.has_value) errors.mean /= static_cast<double>(count - errors.failures);
  }
  return all;
}

}  // namespace sweepkit::texmap
