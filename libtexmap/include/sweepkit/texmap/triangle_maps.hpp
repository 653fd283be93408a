// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>

#include "sweepkit/texmap/area_ratio_mapping.hpp"
#include "sweepkit/texmap/barycentric_mapping.hpp"
#include "sweepkit/texmap/cevian_mapping.hpp"
#include "sweepkit/texmap/distortion.hpp"
#include "sweepkit/texmap/doubled_vertex_mapping.hpp"
#include "sweepkit/texmap/matrix_mapping.hpp"

namespace sweepkit::texmap {

/// All five methods, in the paper's order; the last is the default.
using TriangleMaps = std::tuple<BarycentricMap, DoubledVertexMap, MatrixMap, CevianMap, AreaRatioMap>;

/// How far from the texture triangle's centroid a method puts the model triangle's, which the paper names as
/// a cause of distortion [Akdemir98, section 2.2]. 0 but for rounding where the map is affine.
struct CentroidError {
  std::string_view method;
  double distance;  ///< in (u,v); NaN or infinite where the method has no value for this triangle
};

/// One for each of TriangleMaps, in order.
std::array<CentroidError, std::tuple_size_v<TriangleMaps>> centroid_errors(const Triangle3<double>& t1,
                                                                           const RightTriangle& t2);

/// The same over all triangles of a surface that are right triangles of the texture with their right angle at
/// the second corner, as those of sweeps are; others are left out. No names where no triangle is one.
struct CentroidErrors {
  std::string_view method;
  double mean = 0;           ///< in longer legs of the texture's triangle
  double worst = 0;          ///< the same
  std::size_t failures = 0;  ///< triangles for which the method has no value; not in the two above
  bool has_value = false;    ///< for any triangle
};
std::array<CentroidErrors, std::tuple_size_v<TriangleMaps>> summarize_centroid_errors(
    const MappedSurface& surface);

}  // namespace sweepkit::texmap
