// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "wall_distance.hpp"

#include <algorithm>
#include <vector>

namespace sweepkit::report {
namespace {

double triangle_distance(const sweep::Mesh& mesh, const sweep::Triangle& triangle,
                         const SurfaceDistance& distance, int steps) {
  glm::dvec3 corner[3];
  glm::dvec2 uv[3];
  for (std::size_t k = 0; k < 3; ++k) {
    corner[k] = mesh.origin + glm::dvec3(mesh.positions()[triangle[k]]);
    uv[k] = mesh.texcoords()[triangle[k]];
  }
  double largest = 0;
  for (int j = 0; j <= steps; ++j) {
    for (int i = 0; i + j <= steps; ++i) {
      const double a = static_cast<double>(i) / steps;
      const double c = static_cast<double>(j) / steps;
      const double b = 1 - a - c;
      largest = std::max(largest, distance(a * corner[0] + b * corner[1] + c * corner[2],
                                           a * uv[0] + b * uv[1] + c * uv[2]));
    }
  }
  return largest;
}

}  // namespace

double wall_distance(const sweep::Mesh& mesh, const SurfaceDistance& distance, const WallSampling& sampling) {
  struct Found {
    double distance;
    std::uint32_t triangle;
  };
  std::vector<Found> found;
  for (const sweep::GridPatch& patch : mesh.patches) {
    for (std::uint32_t k = 0; k < patch.triangle_count(); ++k) {
      const std::uint32_t triangle = patch.first_triangle + k;
      found.push_back(
          {triangle_distance(mesh, mesh.triangles[triangle], distance, sampling.steps), triangle});
    }
  }
  const std::size_t worst = std::min(sampling.worst, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(worst), found.end(),
                    [](const Found& a, const Found& b) { return a.distance > b.distance; });
  double largest = 0;
  for (std::size_t k = 0; k < worst; ++k) {
    largest = std::max(
        largest, triangle_distance(mesh, mesh.triangles[found[k].triangle], distance, sampling.fine_steps));
  }
  return largest;
}

}  // namespace sweepkit::report
