// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace sweepkit::scene {

/// Positions once each, in the order of their first index; `places` maps the indices given to them. -0 and 0
/// are one place.
std::vector<glm::dvec3> weld(std::span<const glm::dvec3> all, std::vector<std::uint32_t>& places);

}  // namespace sweepkit::scene
