// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Perlin85] for the idea of gradient noise, and for its first form: gradients of every direction
// and a cubic fade (the value that he adds at lattice points is 0 here, as in his own later programs); on
// [Perlin02] for the second: the quintic fade and twelve gradients to the middles of a cube's edges. Departs
// from them in hashing the lattice point itself instead of looking it up in a table of 256, so the noise does
// not come round after 256 cells.

#include "sweepkit/texmap/noise.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "lattice_noise.hpp"

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

double mix(double t, double a, double b) {
  return a + t * (b - a);
}

struct Improved {
  static double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }
  // Dot product of `offset` with the lattice point's gradient.
  static double pull(std::uint32_t hash, const glm::dvec3& offset) {
    const std::uint32_t edge = hash % 12;
    const glm::length_t zero_axis = static_cast<glm::length_t>(edge / 4);
    const double first = offset[(zero_axis + 1) % 3];
    const double second = offset[(zero_axis + 2) % 3];
    return ((edge & 1) != 0 ? -first : first) + ((edge & 2) != 0 ? -second : second);
  }
};

// 256 directions, evenly over the sphere: a spiral by the golden angle.
std::array<glm::dvec3, 256> make_directions() {
  std::array<glm::dvec3, 256> directions;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double z = 1 - static_cast<double>(2 * i + 1) / 256;
    const double r = std::sqrt(1 - z * z);
    const double turn = golden * static_cast<double>(i);
    directions[i] = {r * std::cos(turn), r * std::sin(turn), z};
  }
  return directions;
}

struct Original {
  static double fade(double t) { return t * t * (3 - 2 * t); }
  static double pull(std::uint32_t hash, const glm::dvec3& offset) {
    static const std::array<glm::dvec3, 256> kDirections = make_directions();
    return glm::dot(kDirections[hash & 255], offset);
  }
};

std::int64_t wrapped(std::int64_t cell, std::int64_t period) {
  if (period == 0) return cell;
  const std::int64_t rest = cell % period;
  return rest < 0 ? rest + period : rest;
}

// In a plane of the lattice (`is_flat`: z is whole) what lies above counts for nothing.
template <class Basis, bool is_flat>
double noise_of(const glm::dvec3& position, std::int64_t period_x, std::int64_t period_y) {
  const glm::dvec3 base = glm::floor(position);
  const glm::dvec3 f = position - base;
  const auto x = static_cast<std::int64_t>(base.x);
  const auto y = static_cast<std::int64_t>(base.y);
  const auto z = static_cast<std::int64_t>(base.z);
  const std::array<std::int64_t, 2> ys = {wrapped(y, period_y), wrapped(y + 1, period_y)};
  const double v = Basis::fade(f.y);
  [[maybe_unused]] const double w = Basis::fade(f.z);
  std::array<double, 2> slab;  // at x and x + 1, blended along y and z
  for (int i = 0; i < 2; ++i) {
    const std::uint64_t of_x = hash_x(wrapped(x + i, period_x));
    std::array<double, 2> line;
    for (int j = 0; j < 2; ++j) {
      const std::uint64_t of_xy = hash_y(of_x, ys[static_cast<std::size_t>(j)]);
      double& value = line[static_cast<std::size_t>(j)];
      value = Basis::pull(hash_z(of_xy, z), f - glm::dvec3(i, j, 0));
      if constexpr (!is_flat)
        value = mix(w, value, Basis::pull(hash_z(of_xy, z + 1), f - glm::dvec3(i, j, 1)));
    }
    slab[static_cast<std::size_t>(i)] = mix(v, line[0], line[1]);
  }
  return mix(Basis::fade(f.x), slab[0], slab[1]);
}

}  // namespace

double lattice_noise(const glm::dvec3& position, NoiseBasis basis, std::int64_t period_x,
                     std::int64_t period_y) {
  const auto is_whole = [](double value) { return !(std::abs(value) < kFarthest); };  // NaN, too
  if (is_whole(position.x) || is_whole(position.y) || is_whole(position.z)) return 0;
  const bool is_flat = position.z == std::floor(position.z);
  if (basis == NoiseBasis::kPerlin2002) {
    return is_flat ? noise_of<Improved, true>(position, period_x, period_y)
                   : noise_of<Improved, false>(position, period_x, period_y);
  }
  return is_flat ? noise_of<Original, true>(position, period_x, period_y)
                 : noise_of<Original, false>(position, period_x, period_y);
}

double noise(const glm::dvec3& position, NoiseBasis basis) {
  return lattice_noise(position, basis, 0, 0);
}

}  // namespace sweepkit::texmap
