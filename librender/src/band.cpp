// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "band.hpp"

#include <time.h>

#include <algorithm>
#include <optional>
#include <span>

#include "row_buffers.hpp"

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
  rays.add(other.rays);
  shading.add(other.shading);
  refinement.pixels += other.refinement.pixels;
  refinement.rays += other.refinement.rays;
  refinement.bytes = std::max(refinement.bytes, other.refinement.bytes);
  layer_rays += other.layer_rays;
  shade_seconds += other.shade_seconds;
  row_bytes = std::max(row_bytes, other.row_bytes);
  reflection_bytes = std::max(reflection_bytes, other.reflection_bytes);
  refraction_bytes = std::max(refraction_bytes, other.refraction_bytes);
  share_bytes = std::max(share_bytes, other.share_bytes);
  normal_bytes = std::max(normal_bytes, other.normal_bytes);
  texcoord_bytes = std::max(texcoord_bytes, other.texcoord_bytes);
  visibility_bytes = std::max(visibility_bytes, other.visibility_bytes);
  shrink_bytes = std::max(shrink_bytes, other.shrink_bytes);
}

BandPainter::BandPainter(const scene::Scene& scene, const scene::Plan& plan, const EyeRays& eye_rays,
                         const TreeBuilder& builder, const Shader& shader, const LayerPainter& layers,
                         texmap::TileCache& tiles, const Region& region, int supersampling,
                         const std::optional<Adaptive>& adaptive, std::span<PixelError> errors)
    : scene_(scene),
      builder_(builder),
      shader_(shader),
      layers_(layers),
      tiles_(tiles),
      eye_rays_(eye_rays),
      region_{region.x * supersampling, region.y * supersampling, region.width * supersampling,
              region.height * supersampling},
      supersampling_(supersampling),
      adaptive_(adaptive),
      errors_(errors),
      has_neighbour_rows_(plan.needs_part(scene::Part::kRows)) {}

BandCounts BandPainter::paint(texmap::Image& image, int first, int end,
                              const std::atomic<bool>* is_cancelled) const {
  BandCounts counts;
  texmap::FilterThread filter(tiles_);
  // What is shaded beyond the band to compare its pixels with, and what is traced beyond that.
  const bool is_compared = adaptive_ || !errors_.empty();
  const int reach = is_compared ? 1 : 0;
  const int border = has_neighbour_rows_ ? 1 : 0;
  RowBuffers rows(builder_, eye_rays_,
                  has_neighbour_rows_ ? KeptRows::kBothSides
                  : is_compared       ? KeptRows::kAbove
                                      : KeptRows::kOwn,
                  region_.x - reach - border, region_.x + region_.width + reach + border);
  const auto width = static_cast<std::size_t>(region_.width) + 2 * static_cast<std::size_t>(reach);
  std::vector<glm::dvec4> colors(width);  // and coverage
  std::vector<TreeColor> trees(width);
  // How many eye rays each pixel's colour takes.
  std::vector<std::uint32_t> eye_ray_counts(layers_.is_needed() ? static_cast<std::size_t>(image.width) : 0,
                                            static_cast<std::uint32_t>(supersampling_ * supersampling_));
  std::optional<Shrinker> shrinker;
  if (supersampling_ > 1) shrinker.emplace(supersampling_, image.width);
  std::optional<RefinedRows> refined;
  if (is_compared) {
    refined.emplace(scene_, builder_, shader_, eye_rays_, adaptive_, !errors_.empty(), region_.x - reach,
                    width);
  }

  const int first_y = region_.y + first * supersampling_;
  const int end_y = region_.y + end * supersampling_;
  for (int y = first_y - reach; y < end_y + reach; ++y) {
    if (is_cancelled != nullptr && *is_cancelled) return counts;
    rows.shift_to(y, counts.rays, filter);
    const double start = thread_seconds();
    for (std::size_t i = 0; i < width; ++i) {
      trees[i] = shader_.pixel(rows.window(), eye_rays_, region_.x - reach + static_cast<int>(i), filter,
                               counts.shading);
    }
    std::ranges::transform(trees, colors.begin(), &TreeColor::color);
    counts.shade_seconds += thread_seconds() - start;

    // What is finished now: this row, the one above it, or part of a pixel's.
    const int row = (y - reach - region_.y) / supersampling_;
    float* out = std::get<std::vector<float>>(image.texels).data() +
                 static_cast<std::ptrdiff_t>(image.channels) * row * image.width;
    if (shrinker) {
      const int k = (y - region_.y) % supersampling_;
      shrinker->add(k, colors);
      if (k < supersampling_ - 1) continue;
      shrinker->take(out, image.channels);
    } else {
      std::span<const glm::dvec4> finished = colors;
      if (refined) {
        // The row above has now been compared on all sides.
        refined->add(rows, border, trees);
        if (y - 1 < first_y) continue;
        finished = refined->finish(y - 1, filter, counts.rays, counts.shading).subspan(1, width - 2);
        if (!errors_.empty()) {
          std::ranges::copy(
              refined->errors().subspan(1, width - 2),
              errors_.begin() + static_cast<std::ptrdiff_t>(row) * static_cast<std::ptrdiff_t>(image.width));
        }
        if (layers_.is_needed())
          std::ranges::copy(refined->eye_rays().subspan(1, width - 2), eye_ray_counts.begin());
      }
      for (const glm::dvec4& color : finished) {
        for (glm::length_t c = 0; c < image.channels; ++c) *out++ = static_cast<float>(color[c]);
      }
    }
    if (layers_.is_needed()) {
      const TreeRow* middles = shrinker ? nullptr : refined ? &rows.above() : &rows.middle();
      counts.layer_rays += layers_.fill(row, region_.x / supersampling_, region_.y / supersampling_ + row,
                                        middles, eye_ray_counts);
    }
  }
  counts.row_bytes = has_neighbour_rows_ ? rows.rows()[0].bytes() + rows.rows()[2].bytes() : 0;
  for (const TreeRow& row : rows.rows()) {
    counts.reflection_bytes += row.reflections.capacity() * sizeof(row.reflections[0]);
    counts.refraction_bytes += row.refractions.capacity() * sizeof(row.refractions[0]);
    counts.share_bytes += row.shares.capacity() * sizeof(row.shares[0]);
    counts.normal_bytes += row.normal_bytes();
    counts.texcoord_bytes += row.texcoords.capacity() * sizeof(glm::dvec2);
    counts.visibility_bytes += row.visibility.bytes();
  }
  if (shrinker) counts.shrink_bytes = shrinker->bytes();
  if (refined) counts.refinement = refined->counts();
  return counts;
}

}  // namespace sweepkit::render
