// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/mesh.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// The contour's x,y plane carried along the trajectory in frames (N, B, T), x on N, y on B: sized by the
/// profile, turned by the twist, pointed by the orientation. At the start B is `up` made perpendicular to T,
/// or -Z where T is along it. A closed trajectory closes its frame: the leftover angle is spread by arc
/// length, to the nearest turn that the contour's own symmetry allows. Corners of the trajectory are joined
/// as options.joints says, the section perpendicular to each side kept.
///
/// Triangles face outwards: the exterior of a closed contour however it is drawn, the right-hand side of an
/// open one. u follows the contour and v the trajectory, so that textures are not mirrored seen from outside:
/// a closed contour drawn clockwise is therefore walked the other way, and u runs against the drawing. Caps
/// have (u,v) of their own, the outline fitted into 0..1, y upwards.
///
/// Throws InputError for cell counts out of range (1 to kMaxCells; a closed curve needs 3), a closed contour
/// that lies on one line, a trajectory that turns right back at a corner, a profile below 0 or one that is 0
/// all along, or one that ends elsewhere than it began on a closed trajectory, crease_deg outside of 0 to
/// 180, miter_limit below 1, a repeat that is not finite, more triangles than 32-bit half-edges can number
/// (715 million).
Mesh sweep(const Curve2& contour, const Curve3& trajectory, const SweepOptions& options = {});

/// The same for a contour of several outlines, all closed: one that lies inside of an odd number of others is
/// a hole. Every outline's wall is an area of its own; they share the cells by length. Throws InputError also
/// where one of several is open, and for round caps.
Mesh sweep(std::span<const Curve2> contour, const Curve3& trajectory, const SweepOptions& options = {});

/// The contour (distance from the axis, height) turned about +Y, counter-clockwise seen from +Y. u runs round
/// the turn, to the right seen from outside, v along the contour. Outside is as for sweep(): a vase drawn
/// upwards faces out. A vertex on the axis is a pole (see GridPatch); what of the contour lies on the axis
/// has no surface. Throws InputError where a vertex is beyond the axis (x < 0), where all are on it, for an
/// angle outside of 0 to 360, or as sweep() does.
Mesh revolve(const Curve2& contour, const RevolveOptions& options = {});

/// The same for a contour of several outlines, as sweep() takes them.
Mesh revolve(std::span<const Curve2> contour, const RevolveOptions& options = {});

/// A rectangle of size (x, z) metres in the x,z plane about the origin, facing +Y, u along x, v along -z.
/// Throws InputError unless both are above 0 and finite, and for cell counts out of range.
Mesh plane(glm::dvec2 size, const PlaneOptions& options = {});

}  // namespace sweepkit::sweep
