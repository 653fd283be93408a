// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/law.hpp"

namespace sweepkit::sweep {

enum class Caps {
  kNone,
  kFlat,
  kRound,  ///< a dome, over a circle a hemisphere; a sweep's alone, and for contours without holes
};

/// Cells along each direction; shared among the smooth pieces between corners by length, at least one each.
struct Tessellation {
  int contour = 64;     ///< cells along the contour, 1 to kMaxCells
  int trajectory = 64;  ///< cells along the trajectory; for revolve round the turn
  /// Metres. Where it is given it decides instead of the counts: the surface is no farther from the mesh than
  /// this anywhere, with few triangles where it is straight.
  std::optional<double> tolerance;
  /// A tolerance that takes more triangles is refused, before memory is taken for them.
  std::uint64_t most_triangles = std::numeric_limits<std::uint64_t>::max();
};

/// More cells a side than this are refused: with 2 x 32768^2 triangles 32-bit indices are near their end.
inline constexpr int kMaxCells = 32768;

enum class UvBy { kArcLength, kParameter };

struct UvOptions {
  UvBy by = UvBy::kArcLength;
  glm::dvec2 repeat{1.0, 1.0};  ///< u runs from 0 to repeat.x, v from 0 to repeat.y
  /// Metres, of the texture's width and height. Where it is given it decides in place of `repeat`: as many
  /// repeats as fit, a whole number of them round what is closed. A swept contour is measured as it is drawn,
  /// a turn where the contour is farthest from the axis.
  std::optional<glm::dvec2> size;
};

/// What becomes of a trajectory's corners. The section is kept on both sides, and v goes on by arc length.
enum class Joints {
  kMiter,   ///< the sides meet in the plane between them; beyond SweepOptions::miter_limit a bevel
  kSmooth,  ///< a mitre whose normals do not break
  kRound,   ///< an arc, its radius twice the section's reach
  kBevel,   ///< a chord, mitred at both ends
};

/// How the section stands about the trajectory where no guide says it.
enum class Frames {
  kRotationMinimizing,  ///< turned about the trajectory as little as can be
  kFrenet,              ///< x towards the centre of curvature; through an inflection without a flip
  kFixedUp,             ///< y as far up as can be: no banking
};

/// Where the section's axes point along a trajectory.
struct Orientation {
  Frames frames = Frames::kRotationMinimizing;
  glm::dvec3 up{0, 1, 0};  ///< y at the start, made perpendicular to the trajectory
  std::optional<Curve3>
      guide;  ///< x points at it, both at the same share of their lengths; overrides `frames`
};

/// The contour's size along the trajectory, a factor of at least 0 for each axis.
struct Profile {
  Law x = 1;
  Law y = 1;
};

/// What the contour has changed into at a share of the trajectory's length.
struct MorphKey {
  double at;                    ///< above 0, at most 1
  std::vector<Curve2> contour;  ///< as many outlines and holes as the contour itself
};

struct SweepOptions {
  Tessellation tessellation;
  UvOptions uv;
  double crease_deg = 30;      ///< normals break where the surface bends by more at a corner
  Caps caps = Caps::kFlat;     ///< flat where the contour is closed and the trajectory is open
  bool has_half_edges = true;  ///< write OpenMesh's connectivity
  Joints joints = Joints::kMiter;
  double miter_limit =
      4;  ///< a mitre's length over the section's width, at least 1: 4 mitres down to 29 degrees
  Profile profile;
  std::vector<MorphKey> morph;  ///< ascending; points and corners may differ from key to key
  Law twist_deg = 0;            ///< the section's turn about the trajectory, right-handed
  Orientation orientation;
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
