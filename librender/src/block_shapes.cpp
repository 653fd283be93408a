// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on the surface area heuristic [Goldsmith, Salmon 1987]: of random rays as many meet a box as its area
// says. Departs from it in that there is nothing to split: one shape is chosen for all the blocks of a level,
// from the boxes of a few real ones. Edge lengths would not do: a block may bend.

#include "block_shapes.hpp"

#include <algorithm>

namespace sweepkit::render {
namespace {

constexpr std::uint32_t kSamples = 8;  // more changed no choice on vases, tubes, spheres and planes
constexpr std::uint32_t kSteps = 8;    // a sampled block's vertices, along each side

std::uint32_t blocks_for(std::uint32_t cells, std::uint32_t block) {
  return (cells + block - 1) / block;
}

double half_area(const glm::vec3& size) {
  return static_cast<double>(size.x) * size.y + static_cast<double>(size.y) * size.z +
         static_cast<double>(size.z) * size.x;
}

// The mean over some blocks of columns x rows cells.
double mean_half_area(const scene::MeshView& mesh, const LeafGrid& grid, std::uint32_t columns,
                      std::uint32_t rows) {
  columns = std::min(columns, grid.columns);
  rows = std::min(rows, grid.rows);
  double sum = 0;
  for (std::uint32_t sample = 0; sample < kSamples; ++sample) {
    // Spread by the golden ratio along u and evenly along v.
    const double along_u = 0.618033988749895 * (sample + 0.5);
    const auto i0 =
        static_cast<std::uint32_t>((along_u - static_cast<int>(along_u)) * (grid.columns - columns + 1));
    const auto j0 = static_cast<std::uint32_t>((sample + 0.5) / kSamples * (grid.rows - rows + 1));
    glm::vec3 low(kNowhere);
    glm::vec3 high(-kNowhere);
    const std::uint32_t steps_u = std::min(columns, kSteps);
    const std::uint32_t steps_v = std::min(rows, kSteps);
    for (std::uint32_t m = 0; m <= steps_v; ++m) {
      const std::uint32_t j = j0 + static_cast<std::uint32_t>(std::uint64_t{m} * rows / steps_v);
      for (std::uint32_t k = 0; k <= steps_u; ++k) {
        const std::uint32_t i = i0 + static_cast<std::uint32_t>(std::uint64_t{k} * columns / steps_u);
        const glm::vec3& p = mesh.positions[grid.first_vertex + j * grid.stride + i];
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
    sum += half_area(high - low);
  }
  return sum / kSamples;
}

}  // namespace

std::optional<std::uint32_t> choose_leaf_shape(const scene::MeshView& mesh, const LeafGrid& grid) {
  std::optional<std::uint32_t> best;
  double least = 0;
  for (std::uint32_t shape = 0; shape < kLeafShapes.size(); ++shape) {
    const auto [columns, rows] = kLeafShapes[shape];
    if (columns > grid.columns || rows > grid.rows) continue;
    const double blocks =
        static_cast<double>(blocks_for(grid.columns, columns)) * blocks_for(grid.rows, rows);
    // Squared: where areas are alike, few leaves rather than many.
    const double cost = blocks * blocks * mean_half_area(mesh, grid, columns, rows);
    if (!best || cost < least) {
      best = shape;
      least = cost;
    }
  }
  return best;
}

std::uint8_t choose_log_columns(const scene::MeshView& mesh, const LeafGrid& grid, std::uint32_t columns,
                                std::uint32_t rows, LeafShape child) {
  std::uint8_t best = 2;
  double least = -1;
  for (std::uint8_t log_columns = 0; log_columns <= 4; ++log_columns) {
    const std::uint32_t wide = 1u << log_columns;
    const std::uint32_t high = kWidth >> log_columns;
    const double blocks = static_cast<double>(blocks_for(columns, wide)) * blocks_for(rows, high);
    // Squared: where areas are alike, full nodes rather than many.
    const double cost = blocks * blocks * mean_half_area(mesh, grid, wide * child.columns, high * child.rows);
    if (least < 0 || cost < least) {
      best = log_columns;
      least = cost;
    }
  }
  return best;
}

}  // namespace sweepkit::render
