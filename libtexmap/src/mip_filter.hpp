// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "pyramid.hpp"
#include "sweepkit/texmap/footprint.hpp"
#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::texmap {

/// The texel of the finest level that (u,v) falls in.
glm::vec3 nearest_texel(const Pyramid& pyramid, Wrap wrap, glm::dvec2 uv, TileReader& tiles);

/// The texels about (u,v) of the finest level, interpolated between.
glm::vec3 bilinear(const Pyramid& pyramid, Wrap wrap, glm::dvec2 uv, TileReader& tiles);

/// The same on the two levels whose texels are nearest in size to the footprint's longer step, and between
/// them [Williams83].
glm::vec3 trilinear(const Pyramid& pyramid, Wrap wrap, const Footprint& footprint, TileReader& tiles);

/// The coarsest level: one texel.
glm::vec3 mean_of_all(const Pyramid& pyramid, TileReader& tiles);

/// The floor, where the processor may have no instruction for it. Precondition: |value| < 2^63.
inline double whole(double value) {
  const auto towards_zero = static_cast<double>(static_cast<std::int64_t>(value));
  return towards_zero > value ? towards_zero - 1 : towards_zero;
}

/// (u,v) taken to where the texture is the same and integers suffice: into the first period, or, where the
/// texture is clamped, to a few textures past its edge at most.
glm::dvec2 near_origin(glm::dvec2 uv, Wrap wrap);

}  // namespace sweepkit::texmap
