// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace sweepkit::render {

/// Shadow rays to a light with a radius.
inline constexpr std::size_t kLightSamples = 16;

/// Places on the unit disc, even over its area, with as few gaps as so many allow: the points of Hammersley's
/// set, taken to the disc by area and turned as a whole by `seed`. Neighbouring pixels turn them differently,
/// so what is left of an error is noise and no bands.
std::array<glm::dvec2, kLightSamples> disc_samples(std::uint64_t seed);

}  // namespace sweepkit::render
