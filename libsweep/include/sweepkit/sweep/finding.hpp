// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/mesh.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

enum class FindingKind {
  kFold,      ///< the contour reaches past the trajectory's centre of curvature, or past a short leg's mitre
  kCrossing,  ///< distant parts of the surface go through each other
  kContourCrossing,  ///< the contour goes through itself
  kFoldedMorph,      ///< on its way from one contour to the next the section goes through itself
  kCusp,             ///< the trajectory turns back in a point
  kNoDirection,      ///< `up`, guide or curvature tell no direction: the frame goes on without
  kPrecision,        ///< the coordinates are so large that float32 loses what the object is made of
};

/// Something about a sweep that its mesh shows as a fault. The mesh is made all the same.
struct Finding {
  FindingKind kind;
  double t = 0;  ///< where it is worst: share of the trajectory's length; of a contour crossing the contour's
  double from = 0, to = 0;      ///< the stretch
  std::optional<double> other;  ///< of a crossing: t of the other part
  glm::dvec3 point{0.0};        ///< there, in the object's own space
  /// How bad, by kind: reach / radius of curvature (above 1); metres of depth; angle in degrees; metres lost;
  /// of a morph the share of the way between the two contours.
  double severity = 0;
  std::string problem;  ///< with its numbers: "the contour reaches 0.11 m, the trajectory bends with 0.1 m"
  std::string cure;     ///< "0.909 times the contour fits"
};

/// "fold", "crossing", ...
const char* name_of(FindingKind kind);

/// What the curves of a sweep tell: all kinds but crossings. Throws InputError as sweep() does.
std::vector<Finding> check_sweep(std::span<const Curve2> contour, const Curve3& trajectory,
                                 const SweepOptions& options = {});

/// What the curves of a revolve tell: contour crossings and precision. Throws InputError as revolve() does.
std::vector<Finding> check_revolve(std::span<const Curve2> contour, const RevolveOptions& options = {});

/// Where a mesh goes through itself, at most 16 places, the deepest first. Triangles that share a place do
/// not count, and no depth below what float32 tells. t and `other` are v over v's range, of revolved meshes
/// too.
std::vector<Finding> find_crossings(const Mesh& mesh);

}  // namespace sweepkit::sweep
