// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "section.hpp"
#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::sweep {

/// Where a section's plane stands: (x, y) at center + x x_axis + y y_axis.
struct CapPlane {
  glm::dvec3 center;
  glm::dvec3 x_axis;
  glm::dvec3 y_axis;
  glm::dvec3 normal;  ///< of unit length, outwards
};

/// Closes a piece of a closed section - its outer outline, then the holes in it - with a flat cap, an area of
/// its own, (u,v) the outline fitted into 0..1. `is_mirrored`: seen along the normal from outside, the
/// contour's x runs to the left.
void add_flat_cap(Mesh& mesh, std::span<const Section> piece, const CapPlane& plane, bool is_mirrored);

/// Caps every piece of a contour; `outer_of` as nest_outlines() says.
void add_flat_caps(Mesh& mesh, std::span<const Section> sections, std::span<const std::size_t> outer_of,
                   const CapPlane& plane, bool is_mirrored);

}  // namespace sweepkit::sweep
