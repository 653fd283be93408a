// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "sweep_meshes.hpp"

namespace sweepkit::bench {

/// A tube about a trefoil knot, `round` x `along` cells, without a seam to see; longer than sweep() makes
/// any.
inline render::test::Shape trefoil_tube(std::uint32_t round, std::uint32_t along) {
  constexpr double kRadius = 0.35;
  render::test::Shape shape;
  shape.name = "trefoil";
  const double step = 2 * std::numbers::pi / along;
  const auto knot = [](double s) {
    const double r = 2 + 0.8 * std::cos(3 * s);
    return glm::dvec3(r * std::cos(2 * s), 0.8 * std::sin(3 * s), -r * std::sin(2 * s));
  };
  for (std::uint32_t j = 0; j <= along; ++j) {
    const double s = j == along ? 0 : j * step;
    const glm::dvec3 middle = knot(s);
    const glm::dvec3 tangent = glm::normalize(knot(s + 1e-4) - knot(s - 1e-4));
    // Away from the ring inside of the torus that the knot winds about: never along the tangent.
    const glm::dvec3 ring(2 * std::cos(2 * s), 0, -2 * std::sin(2 * s));
    const glm::dvec3 out = middle - ring;
    const glm::dvec3 x = glm::normalize(out - glm::dot(out, tangent) * tangent);
    const glm::dvec3 y = glm::cross(tangent, x);
    for (std::uint32_t i = 0; i <= round; ++i) {
      const double angle = i == round ? 0 : 2 * std::numbers::pi * i / round;
      shape.positions.emplace_back(middle + kRadius * (std::cos(angle) * x + std::sin(angle) * y));
    }
  }
  sweep::GridPatch patch;
  patch.columns = round;
  patch.rows = along;
  for (std::uint32_t j = 0; j < along; ++j) {
    for (std::uint32_t i = 0; i < round; ++i) {
      const std::uint32_t q = patch.vertex(i + 1, j);
      const std::uint32_t r = patch.vertex(i, j + 1);
      shape.triangles.push_back({r, q - 1, q});
      shape.triangles.push_back({q, r + 1, r});
    }
  }
  shape.patches.push_back(patch);
  return shape;
}

/// About so many triangles, in cells about as wide as high.
inline render::test::Shape vase_of(double triangles) {
  const double turn = std::sqrt(triangles / 2 * 80 / 46);
  return render::test::vase(static_cast<int>(std::round(turn * 46 / 80)), static_cast<int>(std::round(turn)));
}

/// 60 cells round.
inline render::test::Shape trefoil_of(double triangles) {
  return trefoil_tube(60, static_cast<std::uint32_t>(std::round(triangles / 120)));
}

}  // namespace sweepkit::bench
