// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "triangle_map_picture.hpp"

#include "sweepkit/texmap/procedural.hpp"
#include "sweepkit/texmap/triangle_maps.hpp"

namespace sweepkit::bench {
namespace {

using namespace texmap;

constexpr int kCells = 3;      // along each side of the wall
constexpr int kCellSide = 40;  // pixels
constexpr int kZoom = 4;       // a pixel is drawn as this many squared, so that it can be seen
constexpr int kGap = 16;

// A wall whose plane is parallel to nothing.
const glm::dvec3 kCorner(0.3, -0.7, 1.1);
const glm::dvec3 kRight(0.83, 0.17, -0.41);
const glm::dvec3 kUp(0.12, 0.91, 0.29);

// The (u,v), one unit a cell, of the pixel at (x, y). Each cell is two triangles, as a sweep's is; `map`
// takes (triangle, its right triangle, hit).
template <class Map>
glm::dvec2 texcoord_at(int x, int y, Map&& map) {
  const glm::dvec2 place = (glm::dvec2(x, y) + 0.5) / static_cast<double>(kCellSide);
  const glm::dvec2 cell = glm::floor(place);
  const glm::dvec2 inside = place - cell;
  const bool is_lower = inside.x + inside.y <= 1;
  const auto at = [](const glm::dvec2& p) { return glm::vec3(kCorner + p.x * kRight + p.y * kUp); };
  const glm::dvec2 b = is_lower ? cell : cell + 1.0;
  const double step = is_lower ? 1 : -1;
  const Triangle3<float> triangle{at(b + glm::dvec2(0, step)), at(b), at(b + glm::dvec2(step, 0))};
  return glm::dvec2(map(triangle, RightTriangle{b, step, step}, at(place)));
}

}  // namespace

Image draw_diagonals() {
  const Procedural checks{.kind = ProceduralKind::kTiles,
                          .colors = {{0.85f, 0.8f, 0.68f}, {0.08f, 0.2f, 0.28f}, {0.0f, 0.0f, 0.0f}},
                          .scale = 5,
                          .grout = 0};
  constexpr int kSide = kCells * kCellSide * kZoom;
  Image image = make_float_image(2 * kSide + kGap, kSide);
  auto& texels = std::get<std::vector<float>>(image.texels);
  std::fill(texels.begin(), texels.end(), 1.0f);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < 2 * kSide; ++x) {
      const int column = x % kSide / kZoom;
      const int row = (kSide - 1 - y) / kZoom;
      const glm::dvec2 uv = texcoord_at(column, row, [&](const auto&... of) {
        return x < kSide ? map_once<CevianMap>(of...) : area_ratio_map(of...);
      });
      const glm::vec3 color = evaluate(checks, uv, glm::dvec3(0.0));
      const int to = x < kSide ? x : x + kGap;
      for (int k = 0; k < 3; ++k)
        texels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                    static_cast<std::size_t>(to)) +
               static_cast<std::size_t>(k)] = color[k];
    }
  }
  return image;
}

}  // namespace sweepkit::bench
