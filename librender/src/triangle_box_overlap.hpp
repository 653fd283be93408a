// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

namespace sweepkit::render {

/// Does a triangle share a point with boxes of one size? Separating axes (Akenine-Moller 2001): the
/// triangle's plane and the nine products of edges and axes; the boxes' own axes are the caller's, who knows
/// that the bounding boxes meet. What the triangle and the size say alone is found once (Schwarz and Seidel
/// 2010), and a box then costs ten short products.
class TriangleBoxOverlap {
 public:
  TriangleBoxOverlap(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& half) {
    const std::array<glm::dvec3, 3> edge = {b - a, c - b, a - c};
    plane_ = glm::cross(edge[0], edge[1]);
    const double at = glm::dot(plane_, a);
    const double plane_reach = glm::dot(half, glm::abs(plane_));
    plane_low_ = at - plane_reach;
    plane_high_ = at + plane_reach;
    for (int axis = 0; axis < 3; ++axis) {
      const int y = (axis + 1) % 3;
      const int z = (axis + 2) % 3;
      for (std::size_t i = 0; i < 3; ++i) {
        // Across the edge, in the plane perpendicular to the axis.
        Strip& strip = strips_[3 * static_cast<std::size_t>(axis) + i];
        strip.y = -edge[i][z];
        strip.z = edge[i][y];
        const double pa = strip.y * a[y] + strip.z * a[z];
        const double pb = strip.y * b[y] + strip.z * b[z];
        const double pc = strip.y * c[y] + strip.z * c[z];
        const double reach = std::abs(strip.y) * half[y] + std::abs(strip.z) * half[z];
        strip.low = std::min({pa, pb, pc}) - reach;
        strip.high = std::max({pa, pb, pc}) + reach;
      }
    }
  }

  /// The box about `middle`.
  bool operator()(const glm::dvec3& middle) const {
    const double at = glm::dot(plane_, middle);
    if (at < plane_low_ || at > plane_high_) return false;
    for (int axis = 0; axis < 3; ++axis) {
      const double y = middle[(axis + 1) % 3];
      const double z = middle[(axis + 2) % 3];
      for (std::size_t i = 0; i < 3; ++i) {
        const Strip& strip = strips_[3 * static_cast<std::size_t>(axis) + i];
        const double p = strip.y * y + strip.z * z;
        if (p < strip.low || p > strip.high) return false;
      }
    }
    return true;
  }

 private:
  // low <= y * middle.y + z * middle.z <= high, in the two other axes' coordinates.
  struct Strip {
    double y, z;
    double low, high;
  };
  glm::dvec3 plane_;
  double plane_low_, plane_high_;
  std::array<Strip, 9> strips_;
};

}  // namespace sweepkit::render
