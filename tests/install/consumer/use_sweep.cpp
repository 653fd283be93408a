// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A ring: a circle of radius r carried round one of radius R. By Pappus its volume is 2 pi^2 R r^2; a mesh of
// 64 x 128 cells is inscribed and loses a share of (2 pi / 64)^2 / 6 = 0.0016 by the contour's chords and
// about as much of (2 pi / 128)^2 / 6 = 0.0004 by the trajectory's.
#include <cstdio>
#include <numbers>

#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

using namespace sweepkit;

int main() {
  const sweep::Mesh ring =
      sweep::sweep(sweep::circle_contour(0.25), sweep::circle_trajectory(1), {.tessellation = {64, 128}});
  double volume = 0;
  for (const auto& [a, b, c] : ring.triangles) {
    const auto at = [&](std::uint32_t i) { return glm::dvec3(ring.positions()[i]) + ring.origin; };
    volume += glm::dot(at(a), glm::cross(at(b), at(c))) / 6;
  }
  const double share = volume / (2 * std::numbers::pi * std::numbers::pi * 0.25 * 0.25);
  bool is_refused = false;
  try {
    sweep::plane({0, 1});
  } catch (const InputError&) {
    is_refused = true;
  }
  std::printf("sweep: %zu triangles, %.5f of Pappus' volume\n", ring.triangles.size(), share);
  return ring.triangles.size() == 2 * 64 * 128 && share > 0.9975 && share < 0.9985 && is_refused ? 0 : 1;
}
