// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "box_tree.hpp"
#include "ray.hpp"
#include "triangle_intersection.hpp"

namespace sweepkit::render {

/// A ray as the boxes and leaves see it, in float32: moved, in double, to where it enters the mesh's box, so
/// that rounding is relative to the mesh and not to a far eye; its direction's largest component made 1, so
/// that along it a length and a difference of t are the same. Everything is on the safe side: see
/// docs/algorithms/sweep-hierarchy.md for the bounds.
struct CullingRay {
  // Of the near and far plane of each axis: floats from a node's start, and t = plane * inverse + shift, the
  // planes moved outwards by more than any rounding.
  std::uint32_t near_plane[3];
  std::uint32_t far_plane[3];
  float inverse[3];
  float near_shift[3];
  float far_shift[3];
  // Sheared to the axis axes[2]: x = p[axes[0]] - origin[0] + lost[0] + shear[0] * (p[axes[2]] - origin[2]), y
  // likewise; `lost` is what rounding took from the origin.
  int axes[3];
  float origin[3];
  float lost[2];
  float shear[2];
  float shear_error;  ///< of x and y, for the points of the mesh
  // From t of the ray to t here.
  double scale = 1;
  double start = 0;
  double slack = 0;

  float limit(double t) const { return static_cast<float>(std::min(t * scale - start + slack, 0x1p100)); }
};

enum class Reach : std::uint8_t { kMisses, kMayHit, kUnusual };

/// u: half a unit in the last place of float32.
inline constexpr double kFloatRounding = 0x1p-24;

/// kUnusual: numbers so large or small that float32 and the bounds do not hold.
inline Reach reach(const Ray& ray, const ShearedRay& sheared, const BoxTree& tree, CullingRay& out) {
  const glm::dvec3 size = glm::abs(ray.direction);
  const double largest = std::max({size.x, size.y, size.z});
  const glm::dvec3 far = glm::abs(ray.origin);
  const double farthest = std::max({far.x, far.y, far.z});
  // A ray of no direction, or with a component that is no finite number, meets nothing: NaN everywhere.
  const double sum = size.x + size.y + size.z + far.x + far.y + far.z;
  if (!(largest > 0 && sum < kNoEnd)) return sum < kNoEnd || sum != sum ? Reach::kMisses : Reach::kUnusual;
  if (!(largest > 0x1p-300 && largest < 0x1p300 && farthest < 0x1p100)) return Reach::kUnusual;

  const glm::dvec3 direction = ray.direction / largest;
  glm::dvec3 inverse;
  double enter = 0;
  double leave = kNoEnd;
  // Far more than double rounds to: 2^-53 times a few; and ShearedRay's 2^-26 of the largest triangle.
  const double double_error = 0x1p-46 * (farthest + tree.reach);
  const double margin = double_error + 2 * kFloatRounding * tree.reach;
  for (int axis = 0; axis < 3; ++axis) {
    // A direction along the box's faces is turned by so little that it moves nothing by double_error.
    inverse[axis] = 1 / std::copysign(std::max(std::abs(direction[axis]), 0x1p-56), direction[axis]);
    const double to_low = (tree.box.low[axis] - margin - ray.origin[axis]) * inverse[axis];
    const double to_high = (tree.box.high[axis] + margin - ray.origin[axis]) * inverse[axis];
    enter = std::max(enter, std::min(to_low, to_high));
    leave = std::min(leave, std::max(to_low, to_high));
  }
  if (!(enter <= leave)) return Reach::kMisses;

  const glm::dvec3 origin = ray.origin + enter * direction;
  const double error = 4 * double_error;
  const double moved = 24 * kFloatRounding * tree.reach + error;
  for (int axis = 0; axis < 3; ++axis) {
    // Turned by at most 2u: that moves the ray by 2u of the mesh's size.
    const double slope = std::clamp(inverse[axis], -0x1p23, 0x1p23);
    const bool is_backward = slope < 0;
    const double outwards = is_backward ? -moved : moved;
    const auto a = static_cast<std::uint32_t>(axis);
    out.near_plane[axis] = kWidth * (a + (is_backward ? 3 : 0));
    out.far_plane[axis] = kWidth * (a + (is_backward ? 0 : 3));
    out.inverse[axis] = static_cast<float>(slope);
    out.near_shift[axis] = static_cast<float>(-(origin[axis] + outwards) * slope);
    out.far_shift[axis] = static_cast<float>(-(origin[axis] - outwards) * slope);
  }
  const int axes[3] = {sheared.x(), sheared.y(), sheared.z()};
  const double shears[2] = {sheared.shear_x(), sheared.shear_y()};
  double lost[3];
  for (int k = 0; k < 3; ++k) {
    out.axes[k] = axes[k];
    out.origin[k] = static_cast<float>(origin[axes[k]]);
    lost[k] = static_cast<double>(out.origin[k]) - origin[axes[k]];
  }
  for (int k = 0; k < 2; ++k) {
    out.shear[k] = static_cast<float>(-shears[k]);
    out.lost[k] = static_cast<float>(lost[k] - shears[k] * lost[2]);
  }
  out.shear_error = static_cast<float>(10 * kFloatRounding * tree.extent + error);
  out.scale = largest;
  out.start = enter;
  out.slack = 4 * moved;
  return Reach::kMayHit;
}

}  // namespace sweepkit::render
