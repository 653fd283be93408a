// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Perlin85] for the idea of gradient noise and turbulence, and on [Perlin02] for the quintic fade
// and the twelve gradients to the middles of a cube's edges. Departs from them in hashing the lattice point
// itself instead of looking it up in a table of 256, so the noise does not come round after 256 cells, and in
// turning each octave of turbulence against the one before: else all lattices share their planes and their
// origin, and a picture shows them as straight creases and a bright spot.

#include "sweepkit/texmap/noise.hpp"

#include <cmath>
#include <cstdint>

namespace sweepkit::texmap {
namespace {

// From here on every coordinate is whole.
constexpr double kFarthest = 4503599627370496.0;  // 2^52

// The hash of a lattice point, one coordinate after the other, so that corners share their beginnings:
// multiply and fold until every bit of the three reaches the top bits.
std::uint64_t hash_x(std::int64_t x) {
  const std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u;
  return h ^ (h >> 29);
}
std::uint64_t hash_y(std::uint64_t of_x, std::int64_t y) {
  const std::uint64_t h = of_x + static_cast<std::uint64_t>(y) * 0xBF58476D1CE4E5B9u;
  return (h ^ (h >> 32)) * 0x94D049BB133111EBu;
}
std::uint32_t hash_z(std::uint64_t of_xy, std::int64_t z) {
  const std::uint64_t h = of_xy + static_cast<std::uint64_t>(z) * 0xD6E8FEB86659FD93u;
  return static_cast<std::uint32_t>(((h ^ (h >> 31)) * 0xA0761D6478BD642Fu) >> 40);
}

double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

double mix(double t, double a, double b) {
  return a + t * (b - a);
}

// Dot product of `offset` with the lattice point's gradient.
double pull(std::uint32_t hash, const glm::dvec3& offset) {
  const std::uint32_t edge = hash % 12;
  const glm::length_t zero_axis = static_cast<glm::length_t>(edge / 4);
  const double first = offset[(zero_axis + 1) % 3];
  const double second = offset[(zero_axis + 2) % 3];
  return ((edge & 1) != 0 ? -first : first) + ((edge & 2) != 0 ? -second : second);
}

// A rotation by an angle that is no part of a turn about an axis that is none of the lattice's: the rows of
// (2, -14, 23), (26, 7, 2), (-7, 22, 14) have length 27. Then away from the origin.
glm::dvec3 turned(const glm::dvec3& p) {
  return glm::dvec3(2 * p.x - 14 * p.y + 23 * p.z, 26 * p.x + 7 * p.y + 2 * p.z,
                    -7 * p.x + 22 * p.y + 14 * p.z) /
             27.0 +
         glm::dvec3(0.37, 0.61, 0.23);
}

}  // namespace

double noise(const glm::dvec3& position) {
  const auto is_whole = [](double value) { return !(std::abs(value) < kFarthest); };  // NaN, too
  if (is_whole(position.x) || is_whole(position.y) || is_whole(position.z)) return 0;
  const glm::dvec3 base = glm::floor(position);
  const glm::dvec3 f = position - base;
  const auto y = static_cast<std::int64_t>(base.y);
  const auto z = static_cast<std::int64_t>(base.z);
  const double u = fade(f.x);
  const double v = fade(f.y);
  const double w = fade(f.z);
  double slab[2];  // at x and x + 1, blended along y and z
  for (int i = 0; i < 2; ++i) {
    const std::uint64_t of_x = hash_x(static_cast<std::int64_t>(base.x) + i);
    double line[2];
    for (int j = 0; j < 2; ++j) {
      const std::uint64_t of_xy = hash_y(of_x, y + j);
      line[j] = mix(w, pull(hash_z(of_xy, z), f - glm::dvec3(i, j, 0)),
                    pull(hash_z(of_xy, z + 1), f - glm::dvec3(i, j, 1)));
    }
    slab[i] = mix(v, line[0], line[1]);
  }
  return mix(u, slab[0], slab[1]);
}

double turbulence(const glm::dvec3& position, int octaves) {
  double sum = 0;
  double strength = 1;
  glm::dvec3 p = position;
  for (int i = 0; i < octaves; ++i, strength /= 2, p *= 2) {
    p = turned(p);
    sum += strength * std::abs(noise(p));
  }
  return sum;
}

}  // namespace sweepkit::texmap
