// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::scene {

/// Which points the outlines of a shape enclose: those that they wind round in sum (kNonzero), or an odd
/// number of times (kEvenOdd).
enum class FillRule { kNonzero, kEvenOdd };

/// Closed outlines, filled together by one rule.
struct FilledShape {
  FillRule rule = FillRule::kNonzero;
  std::vector<sweep::Curve2> outlines;
};

/// Of the shapes' outlines those that bound the region all shapes fill together, in their order, each with
/// the region on its left. Left out: what has the region on both sides or on neither - no hole by its rule,
/// hidden under another shape, of no area - and all but the first of equal ones. Outlines that cross are kept
/// whole when any part of them bounds the region. The curves stay as they are: flattening serves the decision
/// alone, which takes a few points of each outline and looks left and right of them.
/// Throws InputError when the decision would take more than some seconds.
std::vector<sweep::Curve2> bounding_outlines(std::span<const FilledShape> shapes);

}  // namespace sweepkit::scene
