// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace sweepkit::texmap {

/// T2 of the paper's Fig. 2: a right triangle of the texture, right angle at B2, C2 along u from it, A2 along
/// v. Legs are signed, so one type serves both halves of a cell. By |B2C2| and |B2A2| the paper means their
/// lengths.
struct RightTriangle {
  glm::dvec2 b;   ///< (u, v) of B2
  double bc = 0;  ///< u(C2) - u(B2)
  double ba = 0;  ///< v(A2) - v(B2)
};

/// The right triangle with these corners in order (A2, B2, C2). Precondition: A2.u == B2.u and C2.v == B2.v.
RightTriangle right_triangle(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c);

/// The paper's Fig. 1: a texture divided into columns x rows equal cells, each cut by a diagonal into two
/// right triangles.
struct RightTriangleSubdivision {
  std::uint32_t columns = 1;
  std::uint32_t rows = 1;

  std::uint32_t triangle_count() const { return 2 * columns * rows; }
  /// Triangle 2k is the lower left half of cell k (row by row), 2k + 1 the upper right one.
  RightTriangle triangle(std::uint32_t index) const;
};

}  // namespace sweepkit::texmap
