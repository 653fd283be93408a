// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Perlin85] for the idea of gradient noise and turbulence, and on [Perlin02] for the quintic fade
// and the twelve gradients to the middles of a cube's edges. Departs from them in hashing the lattice point
// itself instead of looking it up in a table of 256, so the noise does not come round after 256 cells.

#include "sweepkit/texmap/noise.hpp"

#include <cmath>
#include <cstdint>

namespace sweepkit::texmap {
namespace {

std::uint32_t hash(std::int64_t x, std::int64_t y, std::int64_t z) {
  // Multiply and fold: every bit of the three coordinates reaches the top bits.
  std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u;
  h = (h ^ (h >> 29)) + static_cast<std::uint64_t>(y) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 32)) * 0x94D049BB133111EBu + static_cast<std::uint64_t>(z) * 0xD6E8FEB86659FD93u;
  h = (h ^ (h >> 31)) * 0xA0761D6478BD642Fu;
  return static_cast<std::uint32_t>(h >> 40);
}

double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

double mix(double t, double a, double b) {
  return a + t * (b - a);
}

// Dot product of `offset` with the lattice point's gradient.
double pull(std::int64_t x, std::int64_t y, std::int64_t z, const glm::dvec3& offset) {
  const std::uint32_t edge = hash(x, y, z) % 12;
  const glm::length_t zero_axis = static_cast<glm::length_t>(edge / 4);
  const double first = offset[(zero_axis + 1) % 3];
  const double second = offset[(zero_axis + 2) % 3];
  return ((edge & 1) != 0 ? -first : first) + ((edge & 2) != 0 ? -second : second);
}

}  // namespace

double noise(const glm::dvec3& position) {
  const glm::dvec3 base = glm::floor(position);
  const glm::dvec3 f = position - base;
  const auto x = static_cast<std::int64_t>(base.x);
  const auto y = static_cast<std::int64_t>(base.y);
  const auto z = static_cast<std::int64_t>(base.z);
  const auto corner = [&](int i, int j, int k) { return pull(x + i, y + j, z + k, f - glm::dvec3(i, j, k)); };
  const double u = fade(f.x);
  const double v = fade(f.y);
  const double w = fade(f.z);
  return mix(w, mix(v, mix(u, corner(0, 0, 0), corner(1, 0, 0)), mix(u, corner(0, 1, 0), corner(1, 1, 0))),
             mix(v, mix(u, corner(0, 0, 1), corner(1, 0, 1)), mix(u, corner(0, 1, 1), corner(1, 1, 1))));
}

double turbulence(const glm::dvec3& position, int octaves) {
  double sum = 0;
  double frequency = 1;
  for (int i = 0; i < octaves; ++i, frequency *= 2) sum += std::abs(noise(position * frequency)) / frequency;
  return sum;
}

}  // namespace sweepkit::texmap
