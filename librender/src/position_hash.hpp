// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <glm/glm.hpp>

namespace sweepkit::render {

/// Scatters the bits of a number: the finalizer of SplitMix64 [Steele14].
inline std::uint64_t scatter(std::uint64_t n) {
  n += 0x9e3779b97f4a7c15u;
  n = (n ^ (n >> 30)) * 0xbf58476d1ce4e5b9u;
  n = (n ^ (n >> 27)) * 0x94d049bb133111ebu;
  return n ^ (n >> 31);
}

/// A number that a place of the picture always has, and its neighbours have others: chance that is the same
/// on every run, thread and crop.
inline std::uint64_t seed_of(const glm::dvec2& place) {
  return scatter(std::bit_cast<std::uint64_t>(place.x) ^ scatter(std::bit_cast<std::uint64_t>(place.y)));
}

/// The upper half of a scattered number, and the lower one, as fractions in [0, 1).
inline glm::dvec2 fractions_of(std::uint64_t scattered) {
  return glm::dvec2(static_cast<double>(scattered >> 32), static_cast<double>(scattered & 0xffffffffu)) *
         0x1p-32;
}

}  // namespace sweepkit::render
