// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Akdemir98, 3.3] and [Fujimoto86]: a grid an object, in the object's own space and so oriented to
// it. The paper divides "with respect to the number of contour and
// trajectory curves" so that a voxel holds about six triangles at most. Here the counts give the mean area of
// a triangle and that the voxel's side: a voxel of side h that a surface passes holds about h^2 / area
// triangles and their neighbours.

#include "seads.hpp"

#include <cmath>

#include "recent.hpp"
#include "triangle_box_overlap.hpp"
#include "triangle_test.hpp"

namespace sweepkit::render {
namespace {

// Measured on the paper's vase (median occupancy and time a ray, docs/algorithms/seads.md): a smaller voxel
// spends more on walking than it saves on triangles.
constexpr double kVoxelAreas = 1.5;
constexpr double kVoxelsPerTriangle = 8;

VoxelGrid grid_over(const scene::MeshView& mesh) {
  Box box;
  double area = 0;
  for (const sweep::Triangle& triangle : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[triangle[0]]);
    const glm::dvec3 b(mesh.positions[triangle[1]]);
    const glm::dvec3 c(mesh.positions[triangle[2]]);
    box.add(a);
    box.add(b);
    box.add(c);
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  const auto count = static_cast<double>(mesh.triangles.size());
  VoxelGrid grid = make_grid(box, std::sqrt(kVoxelAreas * area / count), kVoxelsPerTriangle * count + 8);
  fill_grid(
      grid, static_cast<std::uint32_t>(mesh.triangles.size()),
      [&](std::uint32_t t) {
        Box bounds;
        for (const std::uint32_t v : mesh.triangles[t]) bounds.add(glm::dvec3(mesh.positions[v]));
        return bounds;
      },
      [&](std::uint32_t t, const glm::dvec3& half) {
        const auto& [a, b, c] = mesh.triangles[t];
        return TriangleBoxOverlap(glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]),
                                  glm::dvec3(mesh.positions[c]), half);
      });
  return grid;
}

}  // namespace

Seads::Seads(const scene::MeshView& mesh) : mesh_(mesh), grid_(grid_over(mesh)) {}

void Seads::find_nearest(const Ray& ray, std::uint32_t object, Hit& best) const {
  const ShearedRay sheared(ray);
  Recent recent;
  walk(grid_, ray, best.t, [&](std::size_t voxel, double exit) {
    for (std::uint32_t i = grid_.first[voxel]; i < grid_.first[voxel + 1]; ++i) {
      const std::uint32_t triangle = grid_.items[i];
      Hit found;
      if (recent.add(triangle) && test_triangle(mesh_, sheared, triangle, best.t, found) &&
          !ray.leaves(object, triangle)) {
        keep_nearer(best, found, object, triangle);
      }
    }
    return best.t < exit;  // what lies beyond this voxel is farther
  });
}

bool Seads::is_blocked(const Ray& ray, std::uint32_t object, double end) const {
  const ShearedRay sheared(ray);
  Recent recent;
  bool is_blocked = false;
  walk(grid_, ray, end, [&](std::size_t voxel, double) {
    for (std::uint32_t i = grid_.first[voxel]; i < grid_.first[voxel + 1] && !is_blocked; ++i) {
      const std::uint32_t triangle = grid_.items[i];
      Hit found;
      is_blocked = recent.add(triangle) && test_triangle(mesh_, sheared, triangle, end, found) &&
                   found.t < end && !ray.leaves(object, triangle);
    }
    return is_blocked;
  });
  return is_blocked;
}

std::size_t Seads::count_occupancy(std::vector<std::uint32_t>& counts) const {
  for (std::size_t voxel = 0; voxel + 1 < grid_.first.size(); ++voxel) {
    const std::uint32_t count = grid_.first[voxel + 1] - grid_.first[voxel];
    if (count > 0) counts.push_back(count);
  }
  return grid_.first.empty() ? 0 : grid_.first.size() - 1;
}

}  // namespace sweepkit::render
