// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

namespace sweepkit::render {

inline constexpr double kNoEnd = std::numeric_limits<double>::infinity();
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;               ///< any length but 0; t counts in lengths of it
  std::uint32_t from_object = kNone;  ///< that it leaves, if any
  /// The triangle of it that it leaves for good: a straight ray does not meet that one again, whatever
  /// rounding says of a sliver.
  std::uint32_t from_triangle = kNone;

  bool leaves(std::uint32_t object, std::uint32_t triangle) const {
    return triangle == from_triangle && object == from_object;
  }
};

/// Where a ray meets a triangle (A, B, C): at t, barycentric coordinates (a, b, c).
struct Hit {
  double t = kNoEnd;
  std::uint32_t object = kNone;
  std::uint32_t triangle = kNone;
  double a = 0, b = 0, c = 0;

  bool is_hit() const { return object != kNone; }
  /// The order of hits: the nearer one; at the same t the lower object, then the lower triangle. It does not
  /// depend on the order in which triangles are tested, so every way of searching finds the same hit.
  bool is_before(double other_t, std::uint32_t other_object, std::uint32_t other_triangle) const {
    if (t != other_t) return t < other_t;
    if (object != other_object) return object < other_object;
    return triangle < other_triangle;
  }
};

}  // namespace sweepkit::render
