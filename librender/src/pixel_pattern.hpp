// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace sweepkit::render {

/// Places in the unit square, kMostRefiningRays of them, of which the first 2^k are as even as can be for
/// every k: one in each of the 2^k boxes of equal size, whichever way the square is cut into such.
std::span<const glm::dvec2> pixel_pattern();

}  // namespace sweepkit::render
