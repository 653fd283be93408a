// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>

#include "adversarial_triangles.hpp"

namespace sweepkit::report {

/// The five methods in the order of texmap::TriangleMaps, then the default with nothing kept.
inline constexpr std::array<std::string_view, 6> kMapNames = {
    "barycentric", "doubled-vertex", "matrix", "cevian", "area-ratio", "area-ratio-once"};
/// The rows that are held to the promise.
constexpr bool is_default_map(std::size_t row) {
  return row >= 4;
}

/// What became of one method on one kind of pair. Errors are in (u,v), the legs being 1.
struct MapRecord {
  std::uint64_t pairs = 0;
  std::uint64_t not_finite = 0;  ///< NaN or infinite
  std::uint64_t wrong = 0;       ///< finite, but past 8 steps of the conditioning
  double median = 0;        ///< of the error where it is finite and there is a reference, within a quarter
  double percentile99 = 0;  ///< likewise
  double largest = 0;
  double steps = 0;  ///< largest error over epsilon times the conditioning
};

struct KindRecord {
  std::uint64_t pairs = 0;
  std::uint64_t without_area = 0;  ///< nothing to compare with; finite is all that is asked
  std::uint64_t not_dominant = 0;  ///< the default dropped an axis that it should not have
  std::array<MapRecord, kMapNames.size()> maps;
};

/// The pair that a number stands for; called by several threads at once.
template <class Real>
using CaseMaker = std::function<texmap::MapCase<Real>(std::uint64_t number)>;

/// Triangles with corners in a cube about the origin, hit anywhere at b below `b_most`, b being B1's
/// barycentric coordinate: 0 on the hypotenuse.
template <class Real>
texmap::MapCase<Real> case_near_hypotenuse(double b_most, std::uint64_t number) {
  texmap::CaseRandom random(number);
  const glm::dvec3 a = random.in_cube();
  const glm::dvec3 b = random.in_cube();
  const glm::dvec3 c = random.in_cube();
  using Vec = glm::vec<3, Real>;
  const texmap::Triangle3<Real> triangle{Vec(a), Vec(b), Vec(c)};
  const double of_b = random.between(0, b_most);
  const double of_a = (1 - of_b) * random.between(0, 1);
  return {triangle, Vec(of_a * glm::dvec3(triangle.a) + of_b * glm::dvec3(triangle.b) +
                        (1 - of_a - of_b) * glm::dvec3(triangle.c))};
}

/// Maps `pairs` triangles and hits by all methods, in Real, and holds them to quadruple precision. The
/// default is held to 8 steps of the conditioning and to nothing else; the others are granted an absolute
/// error of 8 steps besides, and what the direction may matter that they look along (ExactMap::leeway). The
/// same record for any number of threads.
template <class Real>
KindRecord measure_map_errors(const CaseMaker<Real>& make, std::uint64_t pairs, unsigned threads);

}  // namespace sweepkit::report
