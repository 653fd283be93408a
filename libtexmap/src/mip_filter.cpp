// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Williams83].

#include "mip_filter.hpp"

#include <algorithm>
#include <cmath>

#include "axis_runs.hpp"

namespace sweepkit::texmap {
namespace {

glm::vec3 color_of(Float4 sum) {
  return glm::vec3(sum[0], sum[1], sum[2]) / sum[3];
}

template <class Texel>
Float4 texel_at(const Pyramid& pyramid, int level, int x, int y, TileReader& tiles) {
  const Texel* tile = pyramid.tile<Texel>(tiles, level, x / kTileSide, y / kTileSide);
  return to_float4(tile[(y % kTileSide) * kTileSide + x % kTileSide]);
}

// `place` in textures, y down.
template <class Texel>
Float4 bilinear_on(const Pyramid& pyramid, int level, Wrap wrap, glm::dvec2 place, TileReader& tiles) {
  const Pyramid::Level& size = pyramid.level(level);
  const glm::dvec2 at = place * glm::dvec2(size.width, size.height) - 0.5;
  const glm::dvec2 corner = glm::floor(at);
  const glm::vec2 f(at - corner);
  const auto x = static_cast<int>(corner.x);
  const auto y = static_cast<int>(corner.y);
  const int x0 = wrapped(x, size.width, wrap).texel;
  const int x1 = wrapped(x + 1, size.width, wrap).texel;
  const int y0 = wrapped(y, size.height, wrap).texel;
  const int y1 = wrapped(y + 1, size.height, wrap).texel;
  const Float4 upper = (1 - f.x) * texel_at<Texel>(pyramid, level, x0, y0, tiles) +
                       f.x * texel_at<Texel>(pyramid, level, x1, y0, tiles);
  const Float4 lower = (1 - f.x) * texel_at<Texel>(pyramid, level, x0, y1, tiles) +
                       f.x * texel_at<Texel>(pyramid, level, x1, y1, tiles);
  return (1 - f.y) * upper + f.y * lower;
}

Float4 bilinear_on(const Pyramid& pyramid, int level, Wrap wrap, glm::dvec2 place, TileReader& tiles) {
  return pyramid.is_float() ? bilinear_on<FloatTexel>(pyramid, level, wrap, place, tiles)
                            : bilinear_on<IntegerTexel>(pyramid, level, wrap, place, tiles);
}

}  // namespace

glm::dvec2 near_origin(glm::dvec2 uv, Wrap wrap) {
  // Wider than any ellipse reaches, so that past it a clamped texture is its edge alone.
  constexpr double kFar = 8;
  if (wrap == Wrap::kClamp) return glm::clamp(uv, glm::dvec2(-kFar), glm::dvec2(1 + kFar));
  const double period = wrap == Wrap::kMirror ? 2 : 1;
  return uv - period * glm::floor(uv / period);
}

glm::vec3 mean_of_all(const Pyramid& pyramid, TileReader& tiles) {
  return color_of(bilinear_on(pyramid, pyramid.level_count() - 1, Wrap::kClamp, glm::dvec2(0.5), tiles));
}

glm::vec3 nearest_texel(const Pyramid& pyramid, Wrap wrap, glm::dvec2 uv, TileReader& tiles) {
  if (!std::isfinite(uv.x + uv.y)) return mean_of_all(pyramid, tiles);
  const Pyramid::Level& size = pyramid.level(0);
  const glm::dvec2 at = glm::floor(near_origin({uv.x, 1 - uv.y}, wrap) * glm::dvec2(size.width, size.height));
  const int x = wrapped(static_cast<int>(at.x), size.width, wrap).texel;
  const int y = wrapped(static_cast<int>(at.y), size.height, wrap).texel;
  return color_of(pyramid.is_float() ? texel_at<FloatTexel>(pyramid, 0, x, y, tiles)
                                     : texel_at<IntegerTexel>(pyramid, 0, x, y, tiles));
}

glm::vec3 bilinear(const Pyramid& pyramid, Wrap wrap, glm::dvec2 uv, TileReader& tiles) {
  if (!std::isfinite(uv.x + uv.y)) return mean_of_all(pyramid, tiles);
  return color_of(bilinear_on(pyramid, 0, wrap, near_origin({uv.x, 1 - uv.y}, wrap), tiles));
}

glm::vec3 trilinear(const Pyramid& pyramid, Wrap wrap, const Footprint& footprint, TileReader& tiles) {
  const glm::dvec2 size(pyramid.level(0).width, pyramid.level(0).height);
  const double step = std::max(glm::length(footprint.dx * size), glm::length(footprint.dy * size));
  const glm::dvec2 uv = footprint.uv;
  if (!std::isfinite(step) || !std::isfinite(uv.x + uv.y)) return mean_of_all(pyramid, tiles);
  const glm::dvec2 place = near_origin({uv.x, 1 - uv.y}, wrap);
  const double last = pyramid.level_count() - 1;
  const double level = step > 1 ? std::min(std::log2(step), last) : 0;
  const int finer = static_cast<int>(level);
  const auto share = static_cast<float>(level - finer);
  const Float4 near = bilinear_on(pyramid, finer, wrap, place, tiles);
  if (share == 0) return color_of(near);
  return color_of((1 - share) * near + share * bilinear_on(pyramid, finer + 1, wrap, place, tiles));
}

}  // namespace sweepkit::texmap
