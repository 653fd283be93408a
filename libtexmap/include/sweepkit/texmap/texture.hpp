// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <variant>

#include "sweepkit/texmap/image.hpp"
#include "sweepkit/texmap/procedural.hpp"

namespace sweepkit::texmap {

enum class Wrap { kRepeat, kClamp, kMirror };

class TexelSource;  // of an image file that is read piece by piece (image_file.hpp)

/// An image laid over (u,v): u to the right, v upwards, the top row at v = 1. Either the whole image is in
/// memory or its file is read as it is needed.
struct ImageTexture {
  std::shared_ptr<const Image> image;
  Wrap wrap = Wrap::kRepeat;
  std::shared_ptr<const TexelSource> file;
};

/// Its texels across and down; 0 where there is no image.
glm::ivec2 size_of(const ImageTexture& texture);

using Texture = std::variant<ImageTexture, Procedural>;

/// The colour at one point, linear RGB: the texel that (u,v) falls in, or the procedural's value. `position`
/// is in the object's own space, metres; only procedurals on position read it. Precondition: the image is in
/// memory. (u,v) that are not finite give the texel (0,0).
glm::vec3 point_sample(const Texture& texture, glm::dvec2 uv, const glm::dvec3& position);

}  // namespace sweepkit::texmap
