// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "band.hpp"

#include <time.h>

#include <algorithm>
#include <array>
#include <optional>

namespace sweepkit::render {
namespace {

// This thread's own time: what else the machine does meanwhile is not shading.
double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

void BandCounts::add(const BandCounts& other) {
  rays.eye += other.rays.eye;
  rays.reflected += other.rays.reflected;
  rays.refracted += other.rays.refracted;
  rays.texcoords += other.rays.texcoords;
  rays.shares += other.rays.shares;
  shading.shadow_rays += other.shading.shadow_rays;
  shading.nodes += other.shading.nodes;
  shading.environment_lookups += other.shading.environment_lookups;
  shading.lookups.textured += other.shading.lookups.textured;
  shading.lookups.filtered += other.shading.lookups.filtered;
  shading.lookups.differentials += other.shading.lookups.differentials;
  layer_rays += other.layer_rays;
  shade_seconds += other.shade_seconds;
  row_bytes = std::max(row_bytes, other.row_bytes);
  reflection_bytes = std::max(reflection_bytes, other.reflection_bytes);
  refraction_bytes = std::max(refraction_bytes, other.refraction_bytes);
  share_bytes = std::max(share_bytes, other.share_bytes);
  texcoord_bytes = std::max(texcoord_bytes, other.texcoord_bytes);
  shrink_bytes = std::max(shrink_bytes, other.shrink_bytes);
}

BandPainter::BandPainter(const scene::Plan& plan, const EyeRays& eye_rays, const TreeBuilder& builder,
                         const Shader& shader, const LayerPainter& layers, texmap::TileCache& tiles,
                         const Region& region, int supersampling)
    : builder_(builder),
      shader_(shader),
      layers_(layers),
      tiles_(tiles),
      eye_rays_(eye_rays),
      region_{region.x * supersampling, region.y * supersampling, region.width * supersampling,
              region.height * supersampling},
      supersampling_(supersampling),
      has_neighbour_rows_(plan.needs_part(scene::Part::kRows)) {}

BandCounts BandPainter::paint(texmap::Image& image, int first, int end,
                              const std::atomic<bool>* is_cancelled) const {
  BandCounts counts;
  texmap::FilterThread filter(tiles_);
  std::array<TreeRow, 3> rows;
  const auto trace = [&](TreeRow& row, int y) {
    const int border = has_neighbour_rows_ ? 1 : 0;
    builder_.build(row, eye_rays_, y, region_.x - border, region_.x + region_.width + border, counts.rays);
  };
  const int large_first = region_.y + first * supersampling_;
  const int large_end = region_.y + end * supersampling_;
  if (has_neighbour_rows_) {
    trace(rows[1], large_first - 1);
    trace(rows[2], large_first);
  }
  const bool has_alpha = image.channels == 4;
  std::vector<glm::dvec4> colors(static_cast<std::size_t>(region_.width));  // and coverage
  // How many eye rays each pixel's colour takes.
  std::vector<std::uint32_t> rays(layers_.is_needed() ? static_cast<std::size_t>(image.width) : 0,
                                  static_cast<std::uint32_t>(supersampling_ * supersampling_));
  std::optional<Shrinker> shrinker;
  if (supersampling_ > 1) shrinker.emplace(supersampling_, image.width);
  auto& texels = std::get<std::vector<float>>(image.texels);

  for (int y = large_first; y < large_end; ++y) {
    if (is_cancelled != nullptr && *is_cancelled) return counts;
    RowWindow window = {&rows[0], &rows[0], &rows[0]};
    if (has_neighbour_rows_) {
      // Row 2 takes the place of row 1, row 3 that of row 2, and row 3 is traced anew.
      std::rotate(rows.begin(), rows.begin() + 1, rows.end());
      trace(rows[2], y + 1);
      window = {&rows[0], &rows[1], &rows[2]};
    } else {
      trace(rows[0], y);
    }
    const double start = thread_seconds();
    for (int x = 0; x < region_.width; ++x) {
      const bool is_left_out = has_alpha && window[1]->root(region_.x + x) < 0;
      colors[static_cast<std::size_t>(x)] =
          is_left_out
              ? glm::dvec4(0.0)
              : glm::dvec4(shader_.pixel(window, eye_rays_, region_.x + x, y, filter, counts.shading), 1);
    }
    counts.shade_seconds += thread_seconds() - start;

    const int row = (y - region_.y) / supersampling_;
    const int k = (y - region_.y) % supersampling_;
    float* out = texels.data() + static_cast<std::size_t>(image.channels) * static_cast<std::size_t>(row) *
                                     static_cast<std::size_t>(image.width);
    if (!shrinker) {
      for (const glm::dvec4& color : colors) {
        for (glm::length_t c = 0; c < image.channels; ++c) *out++ = static_cast<float>(color[c]);
      }
    } else {
      shrinker->add(k, colors);
      if (k == supersampling_ - 1) shrinker->take(out, image.channels);
    }
    if (layers_.is_needed() && k == supersampling_ - 1) {
      counts.layer_rays += layers_.fill(row, region_.x / supersampling_, y / supersampling_,
                                        shrinker ? nullptr : window[1], rays);
    }
  }
  if (has_neighbour_rows_) counts.row_bytes = rows[0].bytes() + rows[2].bytes();
  for (const TreeRow& row : rows) {
    counts.reflection_bytes += row.reflections.capacity() * sizeof(row.reflections[0]);
    counts.refraction_bytes += row.refractions.capacity() * sizeof(row.refractions[0]);
    counts.share_bytes += row.shares.capacity() * sizeof(row.shares[0]);
    counts.texcoord_bytes += row.texcoords.capacity() * sizeof(glm::dvec2);
  }
  if (shrinker) counts.shrink_bytes = shrinker->bytes();
  return counts;
}

}  // namespace sweepkit::render
