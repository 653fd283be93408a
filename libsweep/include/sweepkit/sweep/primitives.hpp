// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

/// Plane primitives lie in the x,y plane about the origin; closed ones begin on +x and run counter-clockwise
/// as seen from +z. Lengths in metres. All throw InputError for sizes that are not above 0 and finite.
Curve2 circle_contour(double radius);
Curve2 ellipse_contour(double x_radius, double y_radius);

/// Begins in the middle of the right side. 0 <= corner_radius <= half of the shorter side.
Curve2 rectangle_contour(double width, double height, double corner_radius = 0);

/// The corners lie on a circle, the first on +x. 3 to 4096 sides.
Curve2 polygon_contour(int sides, double radius);

/// 2 to 2048 points on one circle, the first on +x, and between them inner corners on another.
Curve2 star_contour(int points, double radius, double inner_radius);

/// From one angle to the other, at most a whole turn; clockwise where to_deg < from_deg.
Curve2 arc_contour(double radius, double from_deg, double to_deg);

/// A plane curve laid into the x,z plane: (x, y) becomes (x, 0, -y), counter-clockwise as seen from +y.
Curve3 laid_flat(const Curve2& curve);
Curve3 circle_trajectory(double radius);

/// (radius cos a, pitch a / turn, -radius sin a), from +x, `turns` times round +Y. A pitch below 0 winds
/// down.
Curve3 helix(double radius, double pitch, double turns);

/// See TorusKnotSegment. p and q from 1 to 1000, with no common divisor; tube < radius.
Curve3 torus_knot(int p, int q, double radius, double tube);

}  // namespace sweepkit::sweep
