// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A texture as an image. Each texel is the mean of what it covers: of an image the box, of a procedural
// parts of it under footprints. Areas that share (u,v) are laid out side by side, each in a cell of its own
// with a gutter; one that comes round is drawn again a period to either side, as far as the gutter shows it.
// What no triangle covers is filled from the nearest covered texel, breadth first, so that a filter finds no
// seam.

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

std::uint16_t to_sample(float value) {
  return static_cast<std::uint16_t>(std::lround(65535.0f * std::clamp(value, 0.0f, 1.0f)));
}

// The mean over a texel whose sides are dx and dy: that of its 4 x 4 parts, each under a tent that stays
// inside it, so that an edge between texels stays sharp. Fewer parts make noise worse than points do, one
// makes edges soft.
glm::vec3 texel_mean(const Procedural& procedural, const glm::dvec3& middle, const glm::dvec3& dx,
                     const glm::dvec3& dy) {
  constexpr int kParts = 4;
  constexpr double kHalf = 0.5 / kParts;
  glm::vec3 sum(0.0f);
  for (int j = 0; j < kParts; ++j) {
    for (int i = 0; i < kParts; ++i) {
      const glm::dvec3 part = ((2 * i + 1) * kHalf - 0.5) * dx + ((2 * j + 1) * kHalf - 0.5) * dy;
      sum += evaluate(procedural, {middle + part, kHalf * dx, kHalf * dy});
    }
  }
  return sum / static_cast<float>(kParts * kParts);
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
  const auto& procedural = std::get<Procedural>(texture);
  const glm::dvec3 dx(1 / size.x, 0, 0);
  const glm::dvec3 dy(0, -1 / size.y, 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      canvas.set(x, y, texel_mean(procedural, {(x + 0.5) / size.x, 1 - (y + 0.5) / size.y, 0}, dx, dy));
  }
  return std::move(canvas.image);
}

// Texels low <= (x, y) < high.
struct TexelRect {
  glm::ivec2 low;
  glm::ivec2 high;
};

struct UvRange {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};
};

// Writes every texel of `clip` whose middle lies in the triangle moved by `shift` in (u,v), or on its edge.
void draw_triangle(Canvas& canvas, const TexelRect& clip, const Procedural& procedural,
                   const BakeSurface& surface, const std::array<std::uint32_t, 3>& triangle,
                   const UvTransform& transform, const glm::dvec2& shift) {
  const glm::dvec2 size(canvas.image.width, canvas.image.height);
  const bool is_on_uv = procedural.on == ProceduralOn::kUv;
  std::array<glm::dvec2, 3> p;      // in texels, y down
  std::array<glm::dvec3, 3> place;  // in the space that the pattern is on
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 own(surface.texcoords[triangle[k]]);
    const glm::dvec2 uv = transform.offset + transform.scale * (own + shift);
    p[k] = glm::dvec2(uv.x, 1 - uv.y) * size;
    place[k] = is_on_uv ? glm::dvec3(own, 0) : glm::dvec3(surface.positions[triangle[k]]) + surface.origin;
  }
  const glm::dvec2 low = glm::min(p[0], glm::min(p[1], p[2]));
  const glm::dvec2 high = glm::max(p[0], glm::max(p[1], p[2]));
  const glm::ivec2 first(glm::max(glm::floor(low), glm::dvec2(clip.low)));
  const glm::ivec2 end(glm::min(glm::ceil(high) + 1.0, glm::dvec2(clip.high)));
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  const double whole = cross(p[1] - p[0], p[2] - p[0]);
  if (whole == 0) return;
  const auto weights = [&](const glm::dvec2& q) {
    const double a = cross(p[1] - q, p[2] - q) / whole;
    const double b = cross(p[2] - q, p[0] - q) / whole;
    return glm::dvec3(a, b, 1 - a - b);
  };
  const auto placed = [&](const glm::dvec3& w) { return w.x * place[0] + w.y * place[1] + w.z * place[2]; };
  const glm::dvec3 at_origin = placed(weights({0, 0}));
  const glm::dvec3 dx = placed(weights({1, 0})) - at_origin;
  const glm::dvec3 dy = placed(weights({0, 1})) - at_origin;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      if (canvas.is_covered[canvas.index(x, y)]) continue;
      const glm::dvec3 at_middle = weights({x + 0.5, y + 0.5});
      if (at_middle.x < -1e-9 || at_middle.y < -1e-9 || at_middle.z < -1e-9) continue;
      canvas.set(x, y, texel_mean(procedural, placed(at_middle), dx, dy));
    }
  }
}

// The triangles first..end-1 of an area, and where it comes round its ends again past the seam.
void draw_area(Canvas& canvas, const TexelRect& clip, const Procedural& procedural,
               const BakeSurface& surface, std::uint32_t first, std::uint32_t end,
               const UvTransform& transform, const glm::dvec2& period) {
  constexpr std::array kTurns = {0, -1, 1};
  for (const int i : kTurns) {
    for (const int j : kTurns) {
      if ((i != 0 && !(period.x > 0)) || (j != 0 && !(period.y > 0))) continue;
      for (std::uint32_t t = first; t < end; ++t) {
        draw_triangle(canvas, clip, procedural, surface, surface.triangles[t], transform,
                      glm::dvec2(i, j) * period);
      }
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

glm::ivec2 bake_cells(std::size_t areas) {
  const int columns =
      static_cast<int>(std::ceil(std::sqrt(static_cast<double>(std::max<std::size_t>(areas, 1)))));
  return {columns, std::max(1, (static_cast<int>(areas) + columns - 1) / columns)};
}

int bake_gutter(glm::ivec2 size) {
  return std::max(4, std::min(size.x, size.y) / 64);
}

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

  // A grid of equal cells, one an area, with a gutter inside each.
  const glm::ivec2 cells = bake_cells(areas);
  const int columns = cells.x;
  const glm::dvec2 size(options.width, options.height);
  const glm::dvec2 cell = glm::dvec2(1.0) / glm::dvec2(cells);
  const glm::dvec2 gutter =
      glm::min(glm::dvec2(bake_gutter({options.width, options.height})) / size, 0.25 * cell);
  const auto period_of = [&](std::size_t area) {
    return area < surface.periods.size() ? surface.periods[area] : glm::dvec2(0.0);
  };
  const bool has_gutter = areas > 1 || period_of(0) != glm::dvec2(0.0);

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
    const glm::dvec2 corner =
        glm::dvec2(static_cast<int>(area) % columns, static_cast<int>(area) / columns) * cell;
    const glm::dvec2 low = corner + (has_gutter ? gutter : glm::dvec2(0.0));
    const glm::dvec2 inner = cell - (has_gutter ? 2.0 * gutter : glm::dvec2(0.0));
    UvTransform transform;
    if (first < end) transform = {inner / extent, low - range.low * (inner / extent)};
    const TexelRect clip{glm::ivec2(glm::round(glm::dvec2(corner.x, 1 - corner.y - cell.y) * size)),
                         glm::ivec2(glm::round(glm::dvec2(corner.x + cell.x, 1 - corner.y) * size))};
    draw_area(canvas, clip, *procedural, surface, first, end, transform, period_of(area));
    baked.transforms.push_back(transform);
    first = end;
  }
  fill_uncovered(canvas);
  baked.image = std::move(canvas.image);
  return baked;
}

}  // namespace sweepkit::texmap
