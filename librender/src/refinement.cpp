// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "refinement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "pixel_pattern.hpp"
#include "tree_difference.hpp"

namespace sweepkit::render {
namespace {
double env(const char* n, double d) { const char* v = getenv(n); return v ? atof(v) : d; }
const double kSide = env("SIDE", 1), kPow = env("POW", 2.5), kGain = env("GAIN", 1);
const int kFirst = static_cast<int>(env("FIRST", 4));
const bool kStructure = env("STRUCT", 1) > 0;
}  // namespace

RefinedRows::RefinedRows(const scene::Scene& scene, const TreeBuilder& builder, const Shader& shader,
                         const EyeRays& eye_rays, const Adaptive& options, int first, std::size_t width)
    : scene_(scene),
      builder_(builder),
      shader_(shader),
      eye_rays_(eye_rays),
      options_(options),
      first_(first),
      eye_ray_counts_(width) {}

bool RefinedRows::differ(const TreeRow& row_a, std::size_t a, const glm::dvec3& color_a,
                         const TreeRow& row_b, std::size_t b, const glm::dvec3& color_b) const {
  const glm::dvec3 contrast = glm::abs(color_a - color_b);
  // Written so that what is no number differs.
  if (!(std::max({contrast.r, contrast.g, contrast.b}) <= options_.contrast)) return true;
  return kStructure && render::differ(scene_, row_a, a, row_b, b, options_.contrast);
}

void RefinedRows::add(const RowBuffers& rows, int border, std::span<const glm::dvec3> colors) {
  std::swap(above_, row_);
  row_.colors.assign(colors.begin(), colors.end());
  row_.is_marked.assign(colors.size(), 0);
  const TreeRow& trees = rows.middle();
  const auto skipped = static_cast<std::size_t>(border);
  for (std::size_t i = 1; i < colors.size(); ++i) {
    if (differ(trees, skipped + i - 1, colors[i - 1], trees, skipped + i, colors[i]))
      row_.is_marked[i - 1] = row_.is_marked[i] = 1;
  }
  for (std::size_t i = 0; i < above_.colors.size(); ++i) {
    if (above_.is_marked[i] != 0 && row_.is_marked[i] != 0) continue;
    if (differ(rows.above(), skipped + i, above_.colors[i], trees, skipped + i, colors[i]))
      above_.is_marked[i] = row_.is_marked[i] = 1;
  }
}

std::span<const glm::dvec3> RefinedRows::finish(int y, texmap::FilterThread& filter, RayCounts& rays,
                                                ShadingCounts& shading) {
  std::fill(eye_ray_counts_.begin(), eye_ray_counts_.end(), std::uint16_t{1});
  for (std::size_t i = 1; i + 1 < above_.colors.size(); ++i) {
    if (above_.is_marked[i] == 0) continue;
    int count = 0;
    above_.colors[i] = refine(first_ + static_cast<int>(i), y, count, filter, rays, shading);
    eye_ray_counts_[i] = static_cast<std::uint16_t>(1 + count);
    ++counts_.pixels;
    counts_.rays += static_cast<std::uint64_t>(count);
  }
  return above_.colors;
}

glm::dvec3 RefinedRows::refine(int x, int y, int& count, texmap::FilterThread& filter, RayCounts& rays,
                               ShadingCounts& shading) {
  const std::span<const glm::dvec2> pattern = pixel_pattern();
  glm::dvec3 sum(0.0);
  glm::dvec3 squares(0.0);
  for (int n = kFirst;; n *= 2) {
    samples_.places.clear();
    for (int i = count; i < n; ++i)
      samples_.places.push_back(glm::dvec2(x, y) + pattern[static_cast<std::size_t>(i)]);
    builder_.build(samples_, eye_rays_, rays);
    const double side = kSide / std::sqrt(n);
    for (std::size_t i = 0; i < samples_.places.size(); ++i) {
      const glm::dvec3 color = shader_.sample(samples_, eye_rays_, i, side, filter, shading);
      sum += color;
      squares += color * color;
    }
    count = n;
    const glm::dvec3 spread = squares - sum * sum / static_cast<double>(n);
    const double variance = (spread.r + spread.g + spread.b) / (3.0 * (n - 1));
    const double worth = 0.25 * options_.contrast * options_.contrast * kGain;
    if (2 * n > options_.most_rays || variance <= worth * std::pow(n, kPow)) return sum / static_cast<double>(n);
  }
}

RefinementCounts RefinedRows::counts() const {
  RefinementCounts counts = counts_;
  counts.bytes = samples_.bytes() + (above_.colors.capacity() + row_.colors.capacity()) * sizeof(glm::dvec3);
  return counts;
}

}  // namespace sweepkit::render
