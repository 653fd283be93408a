// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <string_view>
#include <type_traits>

#include "sweepkit/texmap/number_type.hpp"
#include "sweepkit/texmap/triangle_map.hpp"

// Triangles and hits that are hard to map, and what is true of them in quadruple precision, worked out from
// the definition by code that shares nothing with the maps.
namespace sweepkit::texmap {

__extension__ using Quad = __float128;
template <>
inline constexpr double kEpsilon<Quad> = 0x1p-112;
template <>
inline Quad square_root(const Quad& x) {
  const Quad root = std::sqrt(static_cast<double>(x));
  // Newton's step doubles the 53 bits twice; 0 has none to double, and NaN stays.
  if (!(root > 0)) return root;
  const Quad better = (root + x / root) / 2;
  return (better + x / better) / 2;
}

/// What makes a pair hard. b is B1's barycentric coordinate of the hit.
enum class Hardness {
  kNone,        ///< corners in a cube about the origin, the hit anywhere inside
  kHypotenuse,  ///< b from 1 down to 1e-30
  kSliver,      ///< height over length from 1 down to 1e-12
  kSize,        ///< from 1e-20 to 1e20
  kFar,         ///< from the origin, up to a tenth of what leaves a coordinate a digit
  kAxisPlane,   ///< x, y or z is constant
  kAlongAxis,   ///< the plane holds the direction of an axis
  kOrigin,      ///< the plane passes through the origin
  kDiagonal,    ///< x = y, x = -y and the like, exactly
  kOutside,     ///< the hit lies a little outside
  kCorner,      ///< the hit is a corner, or on an edge
  kAll,         ///< slivers of any size, far away, hit near the hypotenuse or outside
  kNoArea,      ///< corners on a line or at one point
};
inline constexpr std::array<std::string_view, 13> kHardnessNames = {
    "ordinary",        "near the hypotenuse", "slivers",           "sizes",
    "far away",        "axis planes",         "along an axis",     "through the origin",
    "diagonal planes", "slightly outside",    "corners and edges", "all at once",
    "no area"};

template <class Real>
struct MapCase {
  Triangle3<Real> triangle;
  glm::vec<3, Real> hit;
};

/// Numbers that depend on the seed alone [Steele14, splitmix64].
class CaseRandom {
 public:
  explicit CaseRandom(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  double power_of_ten(double low, double high) { return std::pow(10.0, between(low, high)); }
  glm::dvec3 in_cube() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }

 private:
  std::uint64_t state_;
};

/// The pair that this number stands for.
template <class Real>
MapCase<Real> make_case(Hardness hardness, std::uint64_t number) {
  CaseRandom random(number * 64 + static_cast<std::uint64_t>(hardness));
  const bool is_all = hardness == Hardness::kAll;
  std::array<glm::dvec3, 3> corner = {random.in_cube(), random.in_cube(), random.in_cube()};  // A1, B1, C1
  glm::dvec3 weight;
  weight.y = random.between(0, 1);
  if (hardness == Hardness::kHypotenuse || (is_all && random.below(2) == 0))
    weight.y = random.power_of_ten(-30, 0);
  weight.x = (1 - weight.y) * random.between(0, 1);
  weight.z = 1 - weight.x - weight.y;

  // Which corner moves where it is said that one does.
  const auto one = static_cast<std::size_t>(random.below(3));
  glm::dvec3& apex = corner[one];
  const glm::dvec3& p = corner[(one + 1) % 3];
  const glm::dvec3& q = corner[(one + 2) % 3];
  const int axis = random.below(3);
  const int next = (axis + 1) % 3;
  if (hardness == Hardness::kHypotenuse && random.below(2) == 0) {
    // A1 and C1 on an axis: there a hit can be 1e-30 off the hypotenuse, which elsewhere rounds away.
    corner[0][next] = corner[0][(axis + 2) % 3] = corner[2][next] = corner[2][(axis + 2) % 3] = 0;
  }
  if (hardness == Hardness::kSliver || is_all)
    apex = p + random.between(-0.2, 1.2) * (q - p) + random.power_of_ten(-12, 0) * random.in_cube();
  if (hardness == Hardness::kAxisPlane) {
    const double height = random.below(2) == 0 ? 0.0 : random.between(-2, 2);
    for (glm::dvec3& c : corner) c[axis] = height;
  }
  if (hardness == Hardness::kAlongAxis) {
    apex = p + random.between(-1, 1) * (q - p);
    apex[axis] += random.between(-1, 1);
  }
  if (hardness == Hardness::kOrigin) apex = random.between(-1, 1) * p + random.between(-1, 1) * q;
  if (hardness == Hardness::kDiagonal) {
    const double sign = random.below(2) == 0 ? 1 : -1;
    for (glm::dvec3& c : corner) c[next] = sign * c[axis];
  }
  if (hardness == Hardness::kOutside || (is_all && random.below(2) == 0)) {
    const int out = random.below(3);
    const double step = random.power_of_ten(-9, -1);
    weight[out] -= weight[out] + step;
    weight[(out + 1) % 3] = 1 - weight[out] - weight[(out + 2) % 3];
  }
  if (hardness == Hardness::kCorner) {
    weight = glm::dvec3(0.0);
    weight[axis] = 1;
    if (random.below(2) == 0) {
      weight[next] = random.between(0, 1);
      weight[axis] = 1 - weight[next];
    }
  }
  if (hardness == Hardness::kNoArea) {
    const int how = random.below(4);
    apex = how == 0 ? p : p + 0.5 * (q - p);
    if (how == 1) corner = {corner[0], corner[0], corner[0]};
    if (how == 2) corner = {glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0)};
  }

  glm::dvec3 offset(0.0);
  constexpr double kDigits = std::is_same_v<Real, float> ? 6 : 15;
  if (hardness == Hardness::kFar || is_all) offset = random.power_of_ten(-1, kDigits) * random.in_cube();
  const double size = hardness == Hardness::kSize || is_all ? random.power_of_ten(-20, 20) : 1;
  for (glm::dvec3& c : corner) c = size * (c + offset);
  using Vec = glm::vec<3, Real>;
  const Triangle3<Real> t{Vec(corner[0]), Vec(corner[1]), Vec(corner[2])};
  // The hit is of the triangle as it is in the number type. On an edge each coordinate is a sum of two terms:
  // the same on both axes of a diagonal plane.
  const glm::dvec3 hit = weight.x * glm::dvec3(t.a) + weight.y * glm::dvec3(t.b) + weight.z * glm::dvec3(t.c);
  return {t, Vec(hit)};
}

/// The affine map of a pair, exact, as the hit seen along the axis that is dropped.
struct ExactMap {
  bool has_area = false;  ///< else there is nothing to compare with
  Quad a = 0, c = 0;      ///< barycentric coordinates
  /// What the error is measured by: how far a and c move, in steps of the number type, when every product
  /// that they are made of does.
  double conditioning_a = 0, conditioning_c = 0;
  /// How far a and c may differ for a map that looks along another direction: the hit is off the plane by its
  /// own rounding. Enough for every direction that is no flatter on the plane than a dominant axis.
  double leeway_a = 0, leeway_c = 0;
  /// Is no other axis longer in the normal, beyond the rounding that finding it may have?
  bool is_dominant = false;
};

template <class Real>
ExactMap exact_map(const MapCase<Real>& sample, int i, int j) {
  using Vec = std::array<Quad, 3>;
  const auto difference = [](const glm::vec<3, Real>& p, const glm::vec<3, Real>& q) {
    return Vec{static_cast<Quad>(p[0]) - q[0], static_cast<Quad>(p[1]) - q[1],
               static_cast<Quad>(p[2]) - q[2]};
  };
  struct Determinant {
    Quad value;
    double products;  // sum of their sizes
  };
  const auto determinant = [](const Vec& p, const Vec& q, int k, int l) {
    const auto m = static_cast<std::size_t>(k);
    const auto n = static_cast<std::size_t>(l);
    const Quad plus = p[m] * q[n];
    const Quad minus = p[n] * q[m];
    return Determinant{plus - minus,
                       std::abs(static_cast<double>(plus)) + std::abs(static_cast<double>(minus))};
  };
  const Vec ba = difference(sample.triangle.a, sample.triangle.b);
  const Vec bc = difference(sample.triangle.c, sample.triangle.b);
  const Vec bh = difference(sample.hit, sample.triangle.b);
  const std::array<Determinant, 3> normal = {determinant(ba, bc, 1, 2), determinant(ba, bc, 2, 0),
                                             determinant(ba, bc, 0, 1)};
  const Determinant whole = normal[static_cast<std::size_t>(3 - i - j)];
  const double area2 = std::abs(static_cast<double>(whole.value));
  // A hundred bits cancelled: quadruple precision does not know the area either.
  if (!(area2 > 0x1p-100 * whole.products)) return {};

  ExactMap exact;
  exact.has_area = true;
  const Determinant of_a = determinant(bh, bc, i, j);
  const Determinant of_c = determinant(ba, bh, i, j);
  exact.a = of_a.value / whole.value;
  exact.c = of_c.value / whole.value;
  exact.conditioning_a = (of_a.products + std::abs(static_cast<double>(exact.a)) * whole.products) / area2;
  exact.conditioning_c = (of_c.products + std::abs(static_cast<double>(exact.c)) * whole.products) / area2;

  const auto as_double = [](const Vec& v) {
    return glm::dvec3(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
  };
  const double normal_length = glm::length(as_double({normal[0].value, normal[1].value, normal[2].value}));
  const Quad volume = normal[0].value * bh[0] + normal[1].value * bh[1] + normal[2].value * bh[2];
  const double off_plane = std::abs(static_cast<double>(volume)) / normal_length;
  // A dominant axis falls on the plane at least as steeply as the diagonal of a cube does on its sides: the
  // foot moves by sqrt(2) of the height, for the reference and for the map in question.
  const double apart = 2 * std::sqrt(2.0) * off_plane;
  exact.leeway_a = apart * glm::length(as_double(bc)) / normal_length;
  exact.leeway_c = apart * glm::length(as_double(ba)) / normal_length;

  // A product of differences has 3 roundings of half an epsilon, their difference a fourth, and so have both
  // that are compared.
  constexpr double kStep = 2 * kEpsilon<double>;  // the default works in double
  exact.is_dominant = true;
  for (const Determinant& other : normal) {
    if (std::abs(static_cast<double>(other.value)) - kStep * other.products > area2 + kStep * whole.products)
      exact.is_dominant = false;
  }
  return exact;
}

}  // namespace sweepkit::texmap
