// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/texture.hpp"

#include <algorithm>
#include <cmath>

#include "texel_source.hpp"

namespace sweepkit::texmap {
namespace {

// The texel that coordinate t (0 to 1 over `size` texels) falls in.
int texel_index(double t, int size, Wrap wrap) {
  if (wrap == Wrap::kRepeat) t -= std::floor(t);
  if (wrap == Wrap::kMirror) {
    t -= 2 * std::floor(t / 2);
    if (t > 1) t = 2 - t;
  }
  const double index = std::floor(t * size);
  // Rounding can reach `size` just below 1; NaN fails both comparisons and lands on 0.
  return index > 0 ? static_cast<int>(std::min(index, static_cast<double>(size - 1))) : 0;
}

}  // namespace

glm::ivec2 size_of(const ImageTexture& texture) {
  if (texture.file) return {texture.file->width(), texture.file->height()};
  return texture.image ? glm::ivec2(texture.image->width, texture.image->height) : glm::ivec2(0);
}

glm::vec3 point_sample(const Texture& texture, glm::dvec2 uv, const glm::dvec3& position) {
  if (const auto* procedural = std::get_if<Procedural>(&texture)) return evaluate(*procedural, uv, position);
  const auto& [image, wrap, file] = std::get<ImageTexture>(texture);
  return image->color(texel_index(uv.x, image->width, wrap), texel_index(1 - uv.y, image->height, wrap));
}

}  // namespace sweepkit::texmap
