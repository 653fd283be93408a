// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "box_tree.hpp"

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
  // Sheared to the axis axes[2]: x = p[axes[0]] - origin[0] + lost[0] + shear[0] * (p[axes[2]] - origin[2]),
  // y likewise; `lost` is what rounding took from the origin.
  int axes[3];
  float origin[3];
  float lost[2];
  float shear[2];
  float shear_error;  ///< of x and y, for the points of the mesh
  double entry[3];    ///< where the ray enters the box
  // From t of the ray to t here.
  double scale = 1;
  double start = 0;
  double slack = 0;

  float limit(double t) const { return static_cast<float>(std::min(t * scale - start + slack, 0x1p100)); }
};

/// kUnusual: numbers so large or small that float32 and the bounds do not hold.
enum class Reach : std::uint8_t { kMisses, kMayHit, kUnusual };

/// u: half a unit in the last place of float32.
inline constexpr double kFloatRounding = 0x1p-24;

}  // namespace sweepkit::render
