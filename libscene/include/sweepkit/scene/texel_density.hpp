// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::scene {

/// Metres of the placed surface along a unit of u and of v: means over the surface, so that where it is wider
/// than on average a texel is wider as well. 0 where the mesh has no area, there or in (u,v).
glm::dvec2 texcoord_lengths(const MeshView& mesh, const glm::dmat3& world_from_object);

/// How large a baked texture is to be.
struct BakeSize {
  int size = 1024;                ///< without a density: texels on the longer side, but for strips
  std::optional<double> density;  ///< texels a metre of the surface, along u and v
  int most = 8192;                ///< on a side, but for a larger `size`: what every graphics card takes
};

inline constexpr double kLeastDensity = 1e-6;  ///< a texel for a thousand kilometres
inline constexpr double kMostDensity = 1e9;    ///< a texel for a nanometre

/// Texels across and down for that texture of the object. Without a density the longer side has `size` and
/// the other one as many as the surface's lengths along u and v ask for, a sixteenth at least: a rope's
/// pattern is to be seen across it as well. Then texels would be long: of a surface more than 16 times as
/// long as wide the longer side has as many more as keep them square, up to 4 times `size` and to `most`.
/// With a density each side has its length times the density, rounded to nearest, 1 at least; where a side
/// would be over `most` both are made smaller alike. A texture that is laid out area by area has room for
/// the largest in each place, and for the gutter.
glm::ivec2 bake_size_of(const MeshView& mesh, const glm::dmat3& world_from_object,
                        const texmap::Texture& texture, const BakeSize& wanted);

}  // namespace sweepkit::scene
