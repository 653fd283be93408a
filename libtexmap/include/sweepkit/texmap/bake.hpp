// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "sweepkit/texmap/image.hpp"
#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::texmap {

/// The surface that a texture is baked from. Triangles of one area may not overlap in (u,v); those of
/// different areas may.
struct BakeSurface {
  std::span<const glm::vec3> positions;  ///< object space, metres, relative to `origin`
  std::span<const glm::vec2> texcoords;
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const std::uint32_t> area_ends;  ///< one past the last triangle of each area, in order
  glm::dvec3 origin{0.0};
};

struct BakeOptions {
  int width = 1024;  ///< 1 to 32768
  int height = 1024;
};

/// baked (u,v) = offset + scale * the mesh's (u,v).
struct UvTransform {
  glm::dvec2 scale{1.0};
  glm::dvec2 offset{0.0};
};

struct BakedTexture {
  Image image;                          ///< 16-bit RGB
  std::vector<UvTransform> transforms;  ///< one an area
};

/// An object's texture as one image. A texture that repeats over the unit square (an image, a periodic
/// procedural on (u,v)) is that square, and the transforms are the identity; any other is laid out area by
/// area over each one's whole (u,v) range, the texels round each filled past its edge so that no seam shows
/// when the image is filtered.
BakedTexture bake(const Texture& texture, const BakeSurface& surface, const BakeOptions& options);

}  // namespace sweepkit::texmap
