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
  /// By area: u and v after which it comes round, 0 where it does not. Empty: none does.
  std::span<const glm::dvec2> periods;
};

struct BakeOptions {
  int width = 1024;  ///< 1 to 32768
  int height = 1024;
  int threads = 0;  ///< 0: as many as the machine has. The image is the same
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

/// Places across and down for so many areas.
glm::ivec2 bake_cells(std::size_t areas);

/// Texels of the gutter round an area in an image of that size.
int bake_gutter(glm::ivec2 size);

/// An object's texture as one image. A texture that repeats over the unit square (an image, a periodic
/// procedural on (u,v)) is that square, and the transforms are the identity; any other is laid out area by
/// area over each one's whole (u,v) range. Each texel is the mean of what it covers.
///
/// Round each area lies a gutter of min(width, height) / 64 texels, at least 4 (at most a quarter of its
/// place): 16 for 1024 x 1024. An area that comes round goes on in it, so that what a filter reads left of
/// the seam is what lies right of it; past an edge the nearest texel goes on. A gutter of g texels keeps
/// areas apart under bilinear filtering on floor(log2(g / 1.5)) levels of a MIP pyramid besides the finest: 3
/// for 1024 x 1024, 1 for up to 256 x 256. One area that does not come round fills the image without a
/// gutter, for clamped wrap.
BakedTexture bake(const Texture& texture, const BakeSurface& surface, const BakeOptions& options);

}  // namespace sweepkit::texmap
