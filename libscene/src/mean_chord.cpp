// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Cauchy's mean chord: lines that meet a body in a random place and direction have 4 V / S of their length in
// it, convex or not, if each stretch inside counts for itself; which is how one wall after another refracts
// and absorbs light. V by the divergence theorem, about the mesh's own origin and in double.

#include "mean_chord.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "weld.hpp"

namespace sweepkit::scene {
namespace {

// Sorted edges that are gone along towards the higher vertex, and those towards the lower one.
bool is_closed(const MeshView& mesh) {
  std::vector<std::uint32_t> places;
  {
    const std::vector<glm::dvec3> all(mesh.positions.begin(), mesh.positions.end());
    weld(all, places);
  }
  std::vector<std::uint64_t> up;
  std::vector<std::uint64_t> down;
  up.reserve(3 * mesh.triangles.size() / 2);
  down.reserve(3 * mesh.triangles.size() / 2);
  for (const sweep::Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t from = places[triangle[i]];
      const std::uint64_t to = places[triangle[(i + 1) % 3]];
      if (from < to) up.push_back(from << 32 | to);
      if (to < from) down.push_back(to << 32 | from);
    }
  }
  if (up.size() != down.size()) return false;
  std::sort(up.begin(), up.end());
  std::sort(down.begin(), down.end());
  return up == down;
}

}  // namespace

std::optional<double> mean_chord(const MeshView& mesh) {
  if (!is_closed(mesh)) return std::nullopt;
  double six_volumes = 0;
  double two_areas = 0;
  for (const sweep::Triangle& triangle : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[triangle[0]]);
    const glm::dvec3 b(mesh.positions[triangle[1]]);
    const glm::dvec3 c(mesh.positions[triangle[2]]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    six_volumes += glm::dot(a, normal);
    two_areas += glm::length(normal);
  }
  const double chord = 4 * (std::abs(six_volumes) / 6) / (two_areas / 2);
  // A flat body that is closed has none but for rounding: at most a few units of float32 of its size.
  const double size = std::sqrt(two_areas);
  if (!(chord > 1e-6 * size)) return std::nullopt;
  return chord;
}

std::size_t mean_chord_bytes(const MeshView& mesh) {
  return mesh.positions.size() * (2 * sizeof(glm::dvec3) + 5 * sizeof(std::uint32_t)) +
         3 * mesh.triangles.size() * sizeof(std::uint64_t);
}

}  // namespace sweepkit::scene
