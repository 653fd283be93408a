// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/right_triangle.hpp"

namespace sweepkit::texmap {

RightTriangle right_triangle(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return {b, c.x - b.x, a.y - b.y};
}

RightTriangle RightTriangleSubdivision::triangle(std::uint32_t index) const {
  const std::uint32_t cell = index / 2;
  const glm::dvec2 size(1.0 / columns, 1.0 / rows);
  const glm::dvec2 low = glm::dvec2(cell % columns, cell / columns) * size;
  if (index % 2 == 0) return {low, size.x, size.y};
  return {low + size, -size.x, -size.y};
}

}  // namespace sweepkit::texmap
