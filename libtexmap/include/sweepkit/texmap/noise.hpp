// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace sweepkit::texmap {

/// Perlin's gradient noise in its improved form [Perlin02]: 0 at whole coordinates, C2, within 1.0364 of 0
/// (and rarely past 0.8); 0 where a coordinate is not finite or past 2^52.
double noise(const glm::dvec3& position);

/// Sum of |noise| over octaves, each twice as fine and half as strong [Perlin85], and turned against the one
/// before so that their lattices do not line up. Below 2.1.
double turbulence(const glm::dvec3& position, int octaves);

}  // namespace sweepkit::texmap
