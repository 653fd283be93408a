// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/triangle_maps.hpp"

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

}  // namespace sweepkit::texmap
