// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>

namespace sweepkit::texmap {

/// Twice the signed area of a, b, q, with the same bits but for the sign whichever of a and b comes first.
inline double side_of_line(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& q) {
  const bool is_turned = b.x < a.x || (b.x == a.x && b.y < a.y);
  const glm::dvec2& from = is_turned ? b : a;
  const glm::dvec2 along = (is_turned ? a : b) - from;
  const glm::dvec2 to = q - from;
  const double side = along.x * to.y - along.y * to.x;
  return is_turned ? -side : side;
}

/// Calls visit(x, y) for each texel of width x height whose middle (x + 0.5, y + 0.5) lies in the triangle. A
/// middle on an edge belongs to one of the two triangles that share it, so that neighbours leave no texel out
/// and share none.
template <class Visit>
void for_each_texel(std::array<glm::dvec2, 3> p, int width, int height, Visit&& visit) {
  const double area = side_of_line(p[0], p[1], p[2]);
  if (!(std::abs(area) > 0)) return;
  if (area < 0) std::swap(p[1], p[2]);
  const auto owns_its_points = [](const glm::dvec2& a, const glm::dvec2& b) {
    return b.y > a.y || (b.y == a.y && b.x < a.x);
  };
  const std::array owns = {owns_its_points(p[0], p[1]), owns_its_points(p[1], p[2]),
                           owns_its_points(p[2], p[0])};
  // The first and last middle inside the box, clamped before they become integers.
  const auto first = [](double low, int size) {
    return static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(size)));
  };
  const auto end = [](double high, int size) {
    return static_cast<int>(std::clamp(std::floor(high - 0.5) + 1, 0.0, static_cast<double>(size)));
  };
  const int x1 = end(std::max({p[0].x, p[1].x, p[2].x}), width);
  const int y1 = end(std::max({p[0].y, p[1].y, p[2].y}), height);
  for (int y = first(std::min({p[0].y, p[1].y, p[2].y}), height); y < y1; ++y) {
    for (int x = first(std::min({p[0].x, p[1].x, p[2].x}), width); x < x1; ++x) {
      bool is_inside = true;
      for (std::size_t k = 0; k < 3 && is_inside; ++k) {
        const double side = side_of_line(p[k], p[(k + 1) % 3], glm::dvec2(x + 0.5, y + 0.5));
        is_inside = side > 0 || (side == 0 && owns[k]);
      }
      if (is_inside) visit(x, y);
    }
  }
}

}  // namespace sweepkit::texmap
