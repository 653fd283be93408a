// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "sweepkit/texmap/right_triangle.hpp"

namespace sweepkit::texmap {

/// Where a triangle of a mesh lies in the subdivided texture: one half of a cell. Cell corners are numbered
/// counter-clockwise from the lower left one (0, 0), (1, 0), (1, 1), (0, 1).
struct HalfCell {
  std::uint32_t cell = 0;    ///< column + columns * row, rows upwards
  std::uint8_t corner = 0;   ///< the cell's corner that holds the right angle
  std::uint8_t b = 0;        ///< the triangle's corner that lies there; the next lies at the cell's next
  std::uint32_t island = 0;  ///< triangles that hang together in (u,v) by edges have the same number
};

/// The paper's right-triangular subdivision (section 2.2, Fig. 1) of a texture for any mesh: which triangle
/// of the mesh lies on which right triangle of the texture.
struct RightTriangleLayout {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::vector<HalfCell> halves;  ///< one a triangle
  std::uint32_t island_count = 0;
  std::size_t lone_triangles = 0;    ///< without a partner across their hypotenuse
  std::size_t interior_edges = 0;    ///< that two triangles share
  std::size_t continuous_edges = 0;  ///< of these, with the same (u,v) on both sides

  /// (u, v) of a triangle's corners in its own order, in 0..1. Corners that cells share have the same bits.
  std::array<glm::dvec2, 3> texcoords(std::size_t triangle) const;

  /// The paper's T2, and with it A, B, C as corners of the triangle: (b - 1, b, b + 1) where the cell's
  /// diagonal falls to the right, (b + 1, b, b - 1) where it rises.
  RightTriangle right_triangle(std::size_t triangle) const;
};

/// Lays a mesh without (u,v) out over a texture, each triangle once, none over another, none mirrored.
/// Triangles are paired across an edge that becomes the diagonal of a cell, so that pairs are as near to
/// rectangles as can be and few triangles are left alone (none of a closed mesh); pairs lie beside their
/// neighbours where there is room, with the shared edge in one place. Corners of equal position are one
/// vertex, whatever their indices. Near-linear time and memory; the same input gives the same layout.
/// Preconditions: finite positions, indices inside them, at most 2^30 triangles.
RightTriangleLayout lay_out_right_triangles(std::span<const glm::vec3> positions,
                                            std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace sweepkit::texmap
