// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "band.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include "row_buffers.hpp"

namespace sweepkit::render {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

void BandCounts::add(const BandCounts& other) {
  rays.eye += other.rays.eye;
  rays.reflected += other.rays.reflected;
  rays.shadow += other.rays.shadow;
  rays.texcoords += other.rays.texcoords;
  shading.smoothed += other.shading.smoothed;
  shading.nodes += other.shading.nodes;
  shading.lookups.textured += other.shading.lookups.textured;
  shading.lookups.filtered += other.shading.lookups.filtered;
  shading.lookups.differentials += other.shading.lookups.differentials;
  refinement.pixels += other.refinement.pixels;
  refinement.rays += other.refinement.rays;
  refinement.bytes = std::max(refinement.bytes, other.refinement.bytes);
  shade_seconds += other.shade_seconds;
  row_bytes = std::max(row_bytes, other.row_bytes);
  link_bytes = std::max(link_bytes, other.link_bytes);
  texcoord_bytes = std::max(texcoord_bytes, other.texcoord_bytes);
  visibility_bytes = std::max(visibility_bytes, other.visibility_bytes);
  shrink_bytes = std::max(shrink_bytes, other.shrink_bytes);
}

BandPainter::BandPainter(const scene::Scene& scene, const scene::Plan& plan, const TreeBuilder& builder,
                         const Shader& shader, texmap::TileCache& tiles, const Region& region,
                         const Options& options)
    : scene_(scene),
      builder_(builder),
      shader_(shader),
      tiles_(tiles),
      eye_rays_(scene.camera, scene.width * options.supersampling, scene.height * options.supersampling),
      region_{region.x * options.supersampling, region.y * options.supersampling,
              region.width * options.supersampling, region.height * options.supersampling},
      supersampling_(options.supersampling),
      adaptive_(options.adaptive),
      has_neighbour_rows_(plan.needs_part(scene::Part::kRows)) {}

BandCounts BandPainter::paint(texmap::Image& image, std::span<std::uint16_t> eye_rays, int first, int end,
                              const std::atomic<bool>* is_cancelled) const {
  BandCounts counts;
  texmap::FilterThread filter(tiles_);
  // What is shaded beyond the band to compare its pixels with, and what is traced beyond that.
  const int reach = adaptive_ ? 1 : 0;
  const int border = has_neighbour_rows_ ? 1 : 0;
  RowBuffers rows(builder_, eye_rays_,
                  has_neighbour_rows_ ? KeptRows::kBothSides
                  : adaptive_         ? KeptRows::kAbove
                                      : KeptRows::kOwn,
                  region_.x - reach - border, region_.x + region_.width + reach + border);
  const auto width = static_cast<std::size_t>(region_.width + 2 * reach);
  std::vector<glm::dvec3> colors(width);
  std::vector<TreeColor> trees(width);
  std::optional<Shrinker> shrinker;
  if (supersampling_ > 1) shrinker.emplace(supersampling_, image.width);
  std::optional<RefinedRows> refined;
  if (adaptive_) refined.emplace(scene_, builder_, shader_, eye_rays_, *adaptive_, region_.x - reach, width);

  const int first_y = region_.y + first * supersampling_;
  const int end_y = region_.y + end * supersampling_;
  for (int y = first_y - reach; y < end_y + reach; ++y) {
    if (is_cancelled != nullptr && *is_cancelled) return counts;
    rows.shift_to(y, counts.rays);
    const Clock::time_point start = Clock::now();
    for (std::size_t i = 0; i < width; ++i) {
      trees[i] = shader_.pixel(rows.window(), eye_rays_, region_.x - reach + static_cast<int>(i), filter,
                               counts.shading);
    }
    std::ranges::transform(trees, colors.begin(), &TreeColor::color);
    counts.shade_seconds += std::chrono::duration<double>(Clock::now() - start).count();

    const auto pixel = static_cast<std::size_t>((y - reach - region_.y) / supersampling_) *
                       static_cast<std::size_t>(image.width);
    float* out = std::get<std::vector<float>>(image.texels).data() + 3 * pixel;
    if (shrinker) {
      const int k = (y - region_.y) % supersampling_;
      shrinker->add(k, colors);
      if (k == supersampling_ - 1) shrinker->take(out);
      continue;
    }
    std::span<const glm::dvec3> finished = colors;
    if (refined) {
      // The row above has now been compared on all sides.
      refined->add(rows, border, trees);
      if (y - 1 < first_y) continue;
      finished = refined->finish(y - 1, filter, counts.rays, counts.shading).subspan(1, width - 2);
    }
    for (const glm::dvec3& color : finished) {
      for (glm::length_t c = 0; c < 3; ++c) *out++ = static_cast<float>(color[c]);
    }
    if (!eye_rays.empty() && refined)
      std::ranges::copy(refined->eye_rays().subspan(1, width - 2),
                        eye_rays.begin() + static_cast<std::ptrdiff_t>(pixel));
  }
  counts.row_bytes = has_neighbour_rows_ ? rows.rows()[0].bytes() + rows.rows()[2].bytes() : 0;
  for (const TreeRow& row : rows.rows()) {
    counts.link_bytes += row.links.capacity() * sizeof(TreeLinks);
    counts.texcoord_bytes += row.texcoords.capacity() * sizeof(glm::dvec2);
    counts.visibility_bytes += row.visibility.bytes();
  }
  if (shrinker) counts.shrink_bytes = shrinker->bytes();
  if (refined) counts.refinement = refined->counts();
  return counts;
}

}  // namespace sweepkit::render
