// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A texture as an image. Each texel is the mean of what it covers: of an image the box, of a procedural as
// texel_means.hpp has it. Areas that share (u,v) are laid out side by side, each in a cell of its own with a
// gutter; one that comes round is drawn again a period to either side, as far as the gutter shows it. First
// it is settled which triangle each texel is of, then colours are worked out in bands of rows, by many
// threads. What no triangle covers is filled from the nearest covered texel, breadth first, so that a filter
// finds no seam.

#include "sweepkit/texmap/bake.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <string>

#include "row_threads.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"
#include "sweepkit/texmap/tile_cache.hpp"
#include "texel_means.hpp"

namespace sweepkit::texmap {
namespace {

std::uint16_t to_sample(float value) {
  return static_cast<std::uint16_t>(std::lround(65535.0f * std::clamp(value, 0.0f, 1.0f)));
}

// How texels lie in the space that a pattern is on: those of a triangle, or of the whole unit square.
struct Patch {
  glm::dvec2 corner{0.0};  // in texels, y down
  glm::dvec3 at_corner{0.0};
  glm::dvec3 dx{0.0};  // a texel on
  glm::dvec3 dy{0.0};
  std::size_t area = 0;
  TexelMeans::Way way = TexelMeans::Way::kPoints;

  PatternFootprint texel(int x, int y) const {
    return {at_corner + (x + 0.5 - corner.x) * dx + (y + 0.5 - corner.y) * dy, dx, dy};
  }
};

constexpr std::uint32_t kNoPatch = 0xFFFFFFFF;

struct Canvas {
  Image image;
  std::vector<Patch> patches;
  std::vector<std::uint32_t> patch_of;  // a texel each; empty: all are of the first, and go on outside

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
  }
  void set(int x, int y, const glm::vec3& color) {
    auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
    for (std::size_t k = 0; k < 3; ++k)
      texels[3 * index(x, y) + k] = to_sample(color[static_cast<glm::length_t>(k)]);
  }
  const Patch* patch(int x, int y) const {
    if (patch_of.empty()) return patches.data();
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return nullptr;
    const std::uint32_t patch = patch_of[index(x, y)];
    return patch == kNoPatch ? nullptr : &patches[patch];
  }
};

Canvas make_canvas(int width, int height) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {{width, height, 3, std::vector<std::uint16_t>(3 * count)}, {}, {}};
}

// Colours rows of a canvas whose texels have their patches. One a thread.
class RowPainter {
 public:
  RowPainter(Canvas& canvas, const TexelMeans& means)
      : canvas_(canvas), means_(means), columns_(static_cast<std::size_t>(canvas.image.width) + 2) {
    for (Row& row : rows_) row.resize(columns_);
  }

  void operator()(int first, int end) {
    look_at(first - 1);
    look_at(first);
    for (int y = first; y < end; ++y) {
      look_at(y + 1);
      for (int x = 0; x < canvas_.image.width; ++x) {
        const Patch* patch = canvas_.patch(x, y);
        if (patch != nullptr) canvas_.set(x, y, glm::vec3(mean(*patch, x, y)));
      }
    }
  }

 private:
  struct Middle {
    const Patch* patch = nullptr;  // none, or one whose texels are told by points
    glm::dvec3 color{0.0};
  };
  using Row = std::vector<Middle>;  // with a texel more on both sides

  Row& row(int y) { return rows_[static_cast<std::size_t>(y + 3) % rows_.size()]; }

  void look_at(int y) {
    Row& middles = row(y);
    for (std::size_t i = 0; i < columns_; ++i) {
      const int x = static_cast<int>(i) - 1;
      const Patch* patch = canvas_.patch(x, y);
      const bool is_of_points = patch != nullptr && patch->way == TexelMeans::Way::kPoints;
      middles[i].patch = is_of_points ? patch : nullptr;
      if (is_of_points) middles[i].color = means_.point(patch->texel(x, y).at);
    }
  }

  glm::dvec3 mean(const Patch& patch, int x, int y) {
    if (patch.way == TexelMeans::Way::kPoints) {
      std::array<const glm::dvec3*, 9> around;
      std::size_t known = 0;
      for (int j = -1; j <= 1; ++j) {
        for (std::size_t i = 0; i <= 2; ++i) {
          const Middle& middle = row(y + j)[static_cast<std::size_t>(x) + i];
          if (middle.patch != nullptr && middle.patch->area == patch.area) around[known++] = &middle.color;
        }
      }
      if (known == around.size()) {
        if (const auto smooth = TexelMeans::smooth_mean(around)) return *smooth;
      }
    }
    return means_.mean(patch.way, patch.texel(x, y), scratch_);
  }

  Canvas& canvas_;
  const TexelMeans& means_;
  std::size_t columns_;
  std::array<Row, 3> rows_;
  TexelScratch scratch_;
};

void paint(Canvas& canvas, const TexelMeans& means, int threads) {
  for_each_band(canvas.image.height, threads, [&] { return RowPainter(canvas, means); });
}

Image bake_unit_square(const Texture& texture, const BakeOptions& options) {
  Canvas canvas = make_canvas(options.width, options.height);
  const glm::dvec2 size(options.width, options.height);
  if (const auto* image = std::get_if<ImageTexture>(&texture)) {
    TileCache tiles;
    const TextureSampler sampler(*image, Filter::kIntegral1, tiles, 0);
    for_each_band(options.height, options.threads, [&] {
      return [&, thread = std::make_unique<FilterThread>(tiles)](int first, int end) {
        for (int y = first; y < end; ++y) {
          for (int x = 0; x < options.width; ++x) {
            const UvBox box{glm::dvec2(x, options.height - y - 1) / size,
                            glm::dvec2(x + 1, options.height - y) / size};
            canvas.set(x, y, sampler.over_box(box, *thread));
          }
        }
      };
    });
    return std::move(canvas.image);
  }
  const TexelMeans means(std::get<Procedural>(texture));
  Patch patch{.at_corner = {0, 1, 0}, .dx = {1 / size.x, 0, 0}, .dy = {0, -1 / size.y, 0}};
  patch.way = means.way_of(patch.dx, patch.dy);
  canvas.patches = {patch};
  paint(canvas, means, options.threads);
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

struct Drawing {
  Canvas& canvas;
  const TexelMeans& means;
  const BakeSurface& surface;
  bool is_on_uv;
};

// An area's place in the image.
struct AreaPlace {
  std::size_t area;
  TexelRect clip;
  UvTransform transform;
};

// Gives the triangle moved by `shift` in (u,v) every texel of the area's whose middle lies in it, or on its
// edge, and that has no triangle yet.
void place_triangle(const Drawing& drawing, const AreaPlace& place,
                    const std::array<std::uint32_t, 3>& triangle, const glm::dvec2& shift) {
  Canvas& canvas = drawing.canvas;
  const BakeSurface& surface = drawing.surface;
  const glm::dvec2 size(canvas.image.width, canvas.image.height);
  std::array<glm::dvec2, 3> p;   // in texels, y down
  std::array<glm::dvec3, 3> at;  // in the space that the pattern is on
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 own(surface.texcoords[triangle[k]]);
    const glm::dvec2 uv = place.transform.offset + place.transform.scale * (own + shift);
    p[k] = glm::dvec2(uv.x, 1 - uv.y) * size;
    at[k] =
        drawing.is_on_uv ? glm::dvec3(own, 0) : glm::dvec3(surface.positions[triangle[k]]) + surface.origin;
  }
  const glm::dvec2 low = glm::min(p[0], glm::min(p[1], p[2]));
  const glm::dvec2 high = glm::max(p[0], glm::max(p[1], p[2]));
  const glm::ivec2 first(glm::max(glm::floor(low), glm::dvec2(place.clip.low)));
  const glm::ivec2 end(glm::min(glm::ceil(high) + 1.0, glm::dvec2(place.clip.high)));
  const glm::dvec2 b = p[1] - p[0];
  const glm::dvec2 c = p[2] - p[0];
  const double whole = b.x * c.y - b.y * c.x;
  if (whole == 0) return;
  const glm::dvec3 to_b = at[1] - at[0];
  const glm::dvec3 to_c = at[2] - at[0];
  Patch patch{.corner = p[0],
              .at_corner = at[0],
              .dx = (c.y * to_b - b.y * to_c) / whole,
              .dy = (b.x * to_c - c.x * to_b) / whole,
              .area = place.area};
  bool is_new = true;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      std::uint32_t& patch_of = canvas.patch_of[canvas.index(x, y)];
      if (patch_of != kNoPatch) continue;
      const glm::dvec2 q = glm::dvec2(x + 0.5, y + 0.5) - p[0];
      const double of_b = (q.x * c.y - q.y * c.x) / whole;
      const double of_c = (b.x * q.y - b.y * q.x) / whole;
      if (of_b < -1e-9 || of_c < -1e-9 || 1 - of_b - of_c < -1e-9) continue;
      if (is_new) {
        patch.way = drawing.means.way_of(patch.dx, patch.dy);
        canvas.patches.push_back(patch);
        is_new = false;
      }
      patch_of = static_cast<std::uint32_t>(canvas.patches.size() - 1);
    }
  }
}

// The triangles first..end-1 of an area, and where it comes round its ends again past the seam.
void place_area(const Drawing& drawing, const AreaPlace& place, std::uint32_t first, std::uint32_t end,
                const glm::dvec2& period) {
  constexpr std::array kTurns = {0, -1, 1};
  for (const int i : kTurns) {
    for (const int j : kTurns) {
      if ((i != 0 && !(period.x > 0)) || (j != 0 && !(period.y > 0))) continue;
      for (std::uint32_t t = first; t < end; ++t)
        place_triangle(drawing, place, drawing.surface.triangles[t], glm::dvec2(i, j) * period);
    }
  }
}

void fill_uncovered(Canvas& canvas) {
  auto& texels = std::get<std::vector<std::uint16_t>>(canvas.image.texels);
  std::deque<std::pair<int, int>> front;
  for (int y = 0; y < canvas.image.height; ++y) {
    for (int x = 0; x < canvas.image.width; ++x) {
      if (canvas.patch_of[canvas.index(x, y)] != kNoPatch) front.push_back({x, y});
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
      if (canvas.patch_of[next] != kNoPatch) continue;
      for (std::size_t k = 0; k < 3; ++k) texels[3 * next + k] = texels[3 * canvas.index(x, y) + k];
      canvas.patch_of[next] = 0;
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
    return {bake_unit_square(texture, options), std::vector<UvTransform>(areas)};
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
  canvas.patch_of.assign(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height),
                         kNoPatch);
  const TexelMeans means(*procedural);
  const Drawing drawing{canvas, means, surface, procedural->on == ProceduralOn::kUv};
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
    place_area(drawing, {area, clip, transform}, first, end, period_of(area));
    baked.transforms.push_back(transform);
    first = end;
  }
  paint(canvas, means, options.threads);
  fill_uncovered(canvas);
  baked.image = std::move(canvas.image);
  return baked;
}

}  // namespace sweepkit::texmap
