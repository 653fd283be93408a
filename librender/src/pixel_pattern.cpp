// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Sobol67], whose first two coordinates are a (0, 2)-sequence, scrambled by [Owen95]: each bit of a
// coordinate is turned or not by chance that depends on the bits above it.

#include "pixel_pattern.hpp"

#include <array>
#include <cstdint>

#include "position_hash.hpp"
#include "sweepkit/render/render.hpp"

namespace sweepkit::render {
namespace {

constexpr int kBits = 16;
constexpr std::uint64_t kSeed = 1;

std::uint32_t scrambled(std::uint32_t bits, std::uint64_t seed) {
  std::uint32_t result = bits;
  for (int k = 0; k < kBits; ++k) {
    const std::uint64_t above = bits >> (kBits - k);
    const std::uint64_t chance = scatter(seed ^ scatter((above << 8) | static_cast<std::uint64_t>(k)));
    result ^= static_cast<std::uint32_t>(chance & 1) << (kBits - 1 - k);
  }
  return result;
}

}  // namespace

std::span<const glm::dvec2> pixel_pattern() {
  static const std::array<glm::dvec2, kMostRefiningRays> kPlaces = [] {
    std::array<glm::dvec2, kMostRefiningRays> places{};
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      // Column k of the generating matrices: a single bit for x; for y the rows of Pascal's triangle by 2.
      std::uint32_t x = 0;
      std::uint32_t y = 0;
      std::uint32_t column = 1u << (kBits - 1);
      for (int k = 0; k < kBits; ++k) {
        if ((i >> k & 1) != 0) {
          x ^= 1u << (kBits - 1 - k);
          y ^= column;
        }
        column ^= column >> 1;
      }
      const glm::dvec2 bits(scrambled(x, kSeed), scrambled(y, ~kSeed));
      places[i] = (bits + 0.5) * 0x1p-16;
    }
    return places;
  }();
  return kPlaces;
}

}  // namespace sweepkit::render
