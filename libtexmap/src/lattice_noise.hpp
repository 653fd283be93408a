// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "sweepkit/texmap/noise.hpp"

namespace sweepkit::texmap {

/// noise() that comes round after so many cells along x and y; 0: never.
double lattice_noise(const glm::dvec3& position, NoiseBasis basis, std::int64_t period_x,
                     std::int64_t period_y);

}  // namespace sweepkit::texmap
