// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/mesh.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// The contour's x,y plane carried along the trajectory in rotation-minimizing frames (N, B, T): x on N, y on
/// B. At the start B is +Y made perpendicular to T, or -Z where T is along +-Y. A closed trajectory closes
/// its frame: the leftover angle is spread by arc length. Corners of the trajectory are mitred. u follows the
/// contour, v the trajectory. Triangles face outwards: the exterior of a closed contour however it is drawn,
/// the right-hand side of an open one. Throws InputError for cell counts out of range, a mitre at a reversal,
/// a mesh over 2^32 vertices.
Mesh sweep(const Curve2& contour, const Curve3& trajectory, const SweepOptions& options = {});

/// The contour (distance from the axis, height) turned about +Y. u runs round the turn, v along the contour.
/// A contour point on the axis is a pole. Throws InputError when the contour crosses the axis, or as sweep()
/// does.
Mesh revolve(const Curve2& contour, const RevolveOptions& options = {});

/// A rectangle of size (x, z) metres in the x,z plane about the origin, facing +Y, u along x, v along -z.
Mesh plane(glm::dvec2 size, const PlaneOptions& options = {});

}  // namespace sweepkit::sweep
