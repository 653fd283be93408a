// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace sweepkit::texmap {

/// Perlin's gradient noise in its improved form [Perlin02]: in [-1, 1], 0 at whole coordinates, C2.
double noise(const glm::dvec3& position);

/// Sum of |noise| over octaves, each twice as fine and half as strong [Perlin85].
double turbulence(const glm::dvec3& position, int octaves);

}  // namespace sweepkit::texmap
