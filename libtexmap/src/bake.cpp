// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A texture as an image. Each texel is the mean of 4 x 4 points of it (a procedural) or of the box it covers
// (an image). Areas that share (u,v) are laid out side by side, each in a cell of its own with a border; what
// no triangle covers is filled from the nearest covered texel, breadth first, so that a filter finds no seam.

#include "sweepkit/texmap/bake.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>

#include "sweepkit/error.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"
#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::texmap {
namespace {

constexpr int kSamples = 4;  // along each side of a texel
constexpr int kBorder = 4;   // texels round each area's cell: more than a bilinear or 4-texel filter reaches

std::uint16_t to_sample(float value) {
  return static_cast<std::uint16_t>(std::lround(65535.0f * std::clamp(value, 0.0f, 1.0f)));
}

struct Canvas {
  Image image;
  std::vector<bool> is_covered;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
  }
  void set(int x, int y, const glm::vec3& color) {
    auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
    for (std::size_t k = 0; k < 3; ++k)
      texels[3 * index(x, y) + k] = to_sample(color[static_cast<glm::length_t>(k)]);
    is_covered[index(x, y)] = true;
  }
};

Canvas make_canvas(int width, int height) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {{width, height, 3, std::vector<std::uint16_t>(3 * count)}, std::vector<bool>(count)};
}

// The colour of the texel at (x, y), position found by `position_at` for each (u, v) in it.
template <class UvAt, class PositionAt>
glm::vec3 texel_mean(const Texture& texture, int x, int y, UvAt&& uv_at, PositionAt&& position_at) {
  glm::vec3 sum(0.0f);
  for (int b = 0; b < kSamples; ++b) {
    for (int a = 0; a < kSamples; ++a) {
      const glm::dvec2 uv = uv_at(glm::dvec2(x + (a + 0.5) / kSamples, y + (b + 0.5) / kSamples));
      sum += point_sample(texture, uv, position_at(uv));
    }
  }
  return sum / static_cast<float>(kSamples * kSamples);
}

Image bake_unit_square(const Texture& texture, int width, int height) {
  Canvas canvas = make_canvas(width, height);
  const glm::dvec2 size(width, height);
  if (const auto* image = std::get_if<ImageTexture>(&texture)) {
    TileCache tiles;
    FilterThread thread(tiles);
    const TextureSampler sampler(*image, Filter::kIntegral1, tiles, 0);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        canvas.set(x, y,
                   sampler.over_box(
                       {glm::dvec2(x, height - y - 1) / size, glm::dvec2(x + 1, height - y) / size}, thread));
      }
    }
    return std::move(canvas.image);
  }
  const auto uv_at = [&](const glm::dvec2& p) { return glm::dvec2(p.x, size.y - p.y) / size; };
  const auto nowhere = [](const glm::dvec2&) { return glm::dvec3(0.0); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) canvas.set(x, y, texel_mean(texture, x, y, uv_at, nowhere));
  }
  return std::move(canvas.image);
}

struct UvRange {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};
};

// Writes every texel whose middle lies in the triangle, or on its edge.
void draw_triangle(Canvas& canvas, const Texture& texture, const BakeSurface& surface,
                   const std::array<std::uint32_t, 3>& triangle, const UvTransform& transform) {
  const glm::dvec2 size(canvas.image.width, canvas.image.height);
  std::array<glm::dvec2, 3> p;  // in texels, y down
  std::array<glm::dvec3, 3> position;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 uv = transform.offset + transform.scale * glm::dvec2(surface.texcoords[triangle[k]]);
    p[k] = glm::dvec2(uv.x, 1 - uv.y) * size;
    position[k] = glm::dvec3(surface.positions[triangle[k]]) + surface.origin;
  }
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  const double whole = cross(p[1] - p[0], p[2] - p[0]);
  if (whole == 0) return;
  const auto weights = [&](const glm::dvec2& q) {
    const double a = cross(p[1] - q, p[2] - q) / whole;
    const double b = cross(p[2] - q, p[0] - q) / whole;
    return glm::dvec3(a, b, 1 - a - b);
  };
  const auto uv_at = [&](const glm::dvec2& q) {
    return (glm::dvec2(q.x, size.y - q.y) / size - transform.offset) / transform.scale;
  };
  const int x0 = std::max(0, static_cast<int>(std::floor(std::min({p[0].x, p[1].x, p[2].x}))));
  const int x1 =
      std::min(canvas.image.width - 1, static_cast<int>(std::ceil(std::max({p[0].x, p[1].x, p[2].x}))));
  const int y0 = std::max(0, static_cast<int>(std::floor(std::min({p[0].y, p[1].y, p[2].y}))));
  const int y1 =
      std::min(canvas.image.height - 1, static_cast<int>(std::ceil(std::max({p[0].y, p[1].y, p[2].y}))));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      if (canvas.is_covered[canvas.index(x, y)]) continue;
      const glm::dvec3 at_middle = weights({x + 0.5, y + 0.5});
      if (at_middle.x < -1e-9 || at_middle.y < -1e-9 || at_middle.z < -1e-9) continue;
      const auto position_at = [&](const glm::dvec2& uv) {
        const glm::dvec2 baked = transform.offset + transform.scale * uv;
        const glm::dvec3 w = weights(glm::dvec2(baked.x, 1 - baked.y) * size);
        return w.x * position[0] + w.y * position[1] + w.z * position[2];
      };
      canvas.set(x, y, texel_mean(texture, x, y, uv_at, position_at));
    }
  }
}

void fill_uncovered(Canvas& canvas) {
  auto& texels = std::get<std::vector<std::uint16_t>>(canvas.image.texels);
  std::deque<std::pair<int, int>> front;
  for (int y = 0; y < canvas.image.height; ++y) {
    for (int x = 0; x < canvas.image.width; ++x) {
      if (canvas.is_covered[canvas.index(x, y)]) front.push_back({x, y});
    }
  }
  while (!front.empty()) {
    const auto [x, y] = front.front();
    front.pop_front();
    for (const auto& [dx, dy] : {std::pair{-1, 0}, std::pair{1, 0}, std::pair{0, -1}, std::pair{0, 1}}) {
      const int nx = x + dx;
      const int ny = y + dy;
      if (nx < 0 || ny < 0 || nx >= canvas.image.width || ny >= canvas.image.height) continue;
      const std::size_t next = canvas.index(nx, ny);
      if (canvas.is_covered[next]) continue;
      for (std::size_t k = 0; k < 3; ++k) texels[3 * next + k] = texels[3 * canvas.index(x, y) + k];
      canvas.is_covered[next] = true;
      front.push_back({nx, ny});
    }
  }
}

}  // namespace

BakedTexture bake(const Texture& texture, const BakeSurface& surface, const BakeOptions& options) {
  constexpr int kMostTexels = 32768;
  if (options.width < 1 || options.height < 1 || options.width > kMostTexels ||
      options.height > kMostTexels) {
    throw InputError("a baked texture needs 1 to 32768 texels a side, got " + std::to_string(options.width) +
                     " x " + std::to_string(options.height));
  }
  const std::size_t areas = surface.area_ends.size();
  const auto* procedural = std::get_if<Procedural>(&texture);
  if (procedural == nullptr || repeats_in_unit_square(*procedural)) {
    return {bake_unit_square(texture, options.width, options.height), std::vector<UvTransform>(areas)};
  }

  // A grid of equal cells, one an area, with a border inside each.
  const int columns =
      static_cast<int>(std::ceil(std::sqrt(static_cast<double>(std::max<std::size_t>(areas, 1)))));
  const int rows = (static_cast<int>(areas) + columns - 1) / std::max(columns, 1);
  const glm::dvec2 cell = glm::dvec2(1.0) / glm::dvec2(columns, std::max(rows, 1));
  const glm::dvec2 border =
      glm::min(glm::dvec2(kBorder) / glm::dvec2(options.width, options.height), 0.25 * cell);
  const bool needs_border = areas > 1;

  BakedTexture baked;
  Canvas canvas = make_canvas(options.width, options.height);
  std::uint32_t first = 0;
  for (std::size_t area = 0; area < areas; ++area) {
    const std::uint32_t end = surface.area_ends[area];
    UvRange range;
    for (std::uint32_t t = first; t < end; ++t) {
      for (const std::uint32_t vertex : surface.triangles[t]) {
        range.low = glm::min(range.low, glm::dvec2(surface.texcoords[vertex]));
        range.high = glm::max(range.high, glm::dvec2(surface.texcoords[vertex]));
      }
    }
    const glm::dvec2 extent = glm::max(range.high - range.low, glm::dvec2(1e-12));
    const glm::dvec2 low =
        glm::dvec2(static_cast<int>(area) % columns, static_cast<int>(area) / columns) * cell +
        (needs_border ? border : glm::dvec2(0.0));
    const glm::dvec2 inner = cell - (needs_border ? 2.0 * border : glm::dvec2(0.0));
    UvTransform transform;
    if (first < end) transform = {inner / extent, low - range.low * (inner / extent)};
    for (std::uint32_t t = first; t < end; ++t)
      draw_triangle(canvas, texture, surface, surface.triangles[t], transform);
    baked.transforms.push_back(transform);
    first = end;
  }
  fill_uncovered(canvas);
  baked.image = std::move(canvas.image);
  return baked;
}

}  // namespace sweepkit::texmap
