// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <glm/glm.hpp>
#include <string_view>
#include <type_traits>

#include "sweepkit/texmap/right_triangle.hpp"

namespace sweepkit::texmap {

/// A triangle of the model, T1 of the paper's Fig. 2.
template <class Real>
struct Triangle3 {
  glm::vec<3, Real> a, b, c;
};

/// A way from a hit on T1 to its (u,v) on T2, the right triangle of the texture.
///   kName                        stays the same for good: tables are joined by it
///   Prepared                     what is kept for a triangle besides its own corners and T2; empty where
///                                nothing is
///   prepare(t1, t2)              once for a triangle
///   map(prepared, t1, t2, hit)   once for a hit
/// All are templates on the number type, so that float, double, a wider type and one that counts run the same
/// code. Each method's header says where it fails; none throws.
template <class Map, class Real>
concept TriangleMap = requires(const typename Map::template Prepared<Real>& prepared,
                               const Triangle3<Real>& t1, const RightTriangle& t2,
                               const glm::vec<3, Real>& hit) {
  { Map::kName } -> std::convertible_to<std::string_view>;
  { Map::prepare(t1, t2) } -> std::same_as<typename Map::template Prepared<Real>>;
  { Map::map(prepared, t1, t2, hit) } -> std::same_as<glm::vec<2, Real>>;
};

/// Bytes kept for a triangle.
template <class Map, class Real>
constexpr std::size_t kept_bytes() {
  using Prepared = typename Map::template Prepared<Real>;
  return std::is_empty_v<Prepared> ? 0 : sizeof(Prepared);
}

/// (u,v) of a hit, prepared for it alone.
template <class Map, class Real>
glm::vec<2, Real> map_once(const Triangle3<Real>& t1, const RightTriangle& t2, const glm::vec<3, Real>& hit) {
  return Map::map(Map::template prepare<Real>(t1, t2), t1, t2, hit);
}

}  // namespace sweepkit::texmap
