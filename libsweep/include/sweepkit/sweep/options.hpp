// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace sweepkit::sweep {

enum class Caps { kNone, kFlat };

/// Cells along each direction; shared among the smooth pieces between corners by length, at least one each.
struct Tessellation {
  int contour = 64;     ///< cells along the contour, 1 to kMaxCells
  int trajectory = 64;  ///< cells along the trajectory; for revolve round the turn
};

/// More cells a side than this are refused: with 2 x 32768^2 triangles 32-bit indices are near their end.
inline constexpr int kMaxCells = 32768;

enum class UvBy { kArcLength, kParameter };

struct UvOptions {
  UvBy by = UvBy::kArcLength;
  glm::dvec2 repeat{1.0, 1.0};  ///< u runs from 0 to repeat.x, v from 0 to repeat.y
};

struct SweepOptions {
  Tessellation tessellation;
  UvOptions uv;
  double crease_deg = 30;      ///< normals break where the surface bends by more at a corner
  Caps caps = Caps::kFlat;     ///< flat where the contour is closed and the trajectory is open
  bool has_half_edges = true;  ///< write OpenMesh's connectivity
};

struct RevolveOptions {
  Tessellation tessellation;
  UvOptions uv;
  double angle_deg = 360;  ///< 0 < angle <= 360
  double crease_deg = 30;
  Caps caps = Caps::kFlat;  ///< flat at both ends where the contour is closed and the turn is not whole
  bool has_half_edges = true;
};

struct PlaneOptions {
  Tessellation tessellation{1, 1};
  UvOptions uv;
  bool has_half_edges = true;
};

}  // namespace sweepkit::sweep
