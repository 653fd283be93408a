// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace sweepkit::sweep {

struct Box {
  glm::dvec3 low, high;
};

/// The origin for a mesh with this bounding box: its middle, rounded to a multiple of a power of two about as
/// large as the box, so that it is exactly 0 for whatever lies about the world's origin and never costs the
/// positions a bit. Throws InputError for boxes larger or smaller than float32 can hold.
glm::dvec3 choose_origin(const Box& box);

/// How far float32 positions relative to that origin may lie from where they ought to.
double float_error(const Box& box);

/// What a tolerance leaves for the grid. Throws InputError where the positions' rounding alone takes more
/// than half of it.
double tolerance_left(double tolerance, const Box& box);

}  // namespace sweepkit::sweep
