// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "outline.hpp"

namespace sweepkit::scene {

/// The arc from one point to another by its radii [SVG 2, B.2], as one segment: radii that do not reach are
/// enlarged until they do, their signs are dropped, a radius of 0 is a straight line. The points differ.
sweep::Segment<2> elliptical_arc(const glm::dvec2& from, const OutlineBuilder::Arc& arc,
                                 const glm::dvec2& to);

}  // namespace sweepkit::scene
