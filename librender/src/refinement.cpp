// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Akdemir98, 3.2.2], which leaves it to the reader: "an adaptive supersampling, which is less
// expensive, could be used". Textures are averaged over the whole pixel by one ray; what one ray cannot see
// is where surfaces and shadows end, and there its neighbours differ from it. Such a pixel is drawn by n
// rays, n = 4, 8, 16, ..., at the places of pixel_pattern(). Their mean has a squared error of about v /
// n^(3/2) where an edge crosses the pixel, v the variance of the colours, so that one ray more lowers it by
// about v / n^(5/2): rays are given until that is less than (contrast / 12)^2, the same in every pixel, which
// is how a number of rays is best shared out among pixels.
//
// Four rays may all miss what made the pixel differ. So v is estimated with kPriorRays rays added that have
// the variance of a pixel half its own and half its least like neighbour: without them a third of the whole
// error sat in one pixel of a thousand (docs/equal_error.md).

#include "refinement.hpp"

#include <algorithm>
#include <cmath>

#include "pixel_pattern.hpp"
#include "tree_difference.hpp"

namespace sweepkit::render {
namespace {

constexpr int kFirstRays = kFewestRefiningRays;

}  // namespace

RefinedRows::RefinedRows(const scene::Scene& scene, const TreeBuilder& builder, const Shader& shader,
                         const EyeRays& eye_rays, const std::optional<Adaptive>& options, bool tells_errors,
                         int first, std::size_t width)
    : scene_(scene),
      builder_(builder),
      shader_(shader),
      eye_rays_(eye_rays),
      refines_(options.has_value()),
      options_(options.value_or(Adaptive{})),
      first_(first),
      eye_ray_counts_(width),
      errors_(tells_errors ? width : 0) {}

void RefinedRows::compare(const TreeRow& trees_a, std::size_t a, Row& row_a, std::size_t i,
                          const TreeRow& trees_b, std::size_t b, Row& row_b, std::size_t j) const {
  const bool is_other = differ(scene_, trees_a, a, trees_b, b, options_.contrast);
  const glm::dvec3 contrast =
      glm::abs(is_other ? glm::dvec3(row_a.colors[i] - row_b.colors[j]) : row_a.plain[i] - row_b.plain[j]);
  const double variance = glm::dot(contrast, contrast) / 12;  // a quarter of the square, the mean of RGB
  row_a.variance[i] = std::max(row_a.variance[i], variance);
  row_b.variance[j] = std::max(row_b.variance[j], variance);
  // Written so that what is no number differs.
  if (is_other || !(std::max({contrast.r, contrast.g, contrast.b}) <= options_.contrast))
    row_a.is_marked[i] = row_b.is_marked[j] = 1;
}

void RefinedRows::add(const RowBuffers& rows, int border, std::span<const TreeColor> colors) {
  std::swap(above_, row_);
  row_.colors.clear();
  row_.plain.clear();
  for (const TreeColor& tree : colors) {
    row_.colors.push_back(tree.color);
    row_.plain.push_back(tree.plain);
  }
  row_.is_marked.assign(colors.size(), 0);
  row_.variance.assign(colors.size(), 0);
  const TreeRow& trees = rows.middle();
  const auto skipped = static_cast<std::size_t>(border);
  for (std::size_t i = 1; i < colors.size(); ++i)
    compare(trees, skipped + i - 1, row_, i - 1, trees, skipped + i, row_, i);
  for (std::size_t i = 0; i < above_.colors.size(); ++i)
    compare(rows.above(), skipped + i, above_, i, trees, skipped + i, row_, i);
}

std::span<const glm::dvec4> RefinedRows::finish(int y, texmap::FilterThread& filter, RayCounts& rays,
                                                ShadingCounts& shading) {
  std::fill(eye_ray_counts_.begin(), eye_ray_counts_.end(), 1u);
  for (std::size_t i = 1; i + 1 < above_.colors.size(); ++i) {
    if (!errors_.empty()) errors_[i] = {.edge = static_cast<float>(above_.variance[i])};
    if (!refines_ || above_.is_marked[i] == 0) continue;
    const Refined refined =
        refine(first_ + static_cast<int>(i), y, above_.variance[i], filter, rays, shading);
    above_.colors[i] = refined.color;
    const auto count = static_cast<std::uint32_t>(refined.rays);
    eye_ray_counts_[i] = 1 + count;
    if (!errors_.empty()) {
      errors_[i].refined = static_cast<float>(refined.squared_error);
      errors_[i].rays = count;
    }
    ++counts_.pixels;
    counts_.rays += count;
  }
  return above_.colors;
}

RefinedRows::Refined RefinedRows::refine(int x, int y, double expected, texmap::FilterThread& filter,
                                         RayCounts& rays, ShadingCounts& shading) {
  const std::span<const glm::dvec2> pattern = pixel_pattern();
  glm::dvec4 sum(0.0);
  glm::dvec4 squares(0.0);
  int count = 0;
  for (int n = kFirstRays;; n *= 2) {
    samples_.places.clear();
    for (int i = count; i < n; ++i)
      samples_.places.push_back(glm::dvec2(x, y) + pattern[static_cast<std::size_t>(i)]);
    const double side = side_of_sample(n);
    builder_.build(samples_, eye_rays_, rays, &filter, side);
    for (std::size_t i = 0; i < samples_.places.size(); ++i) {
      const glm::dvec4 color = shader_.sample(samples_, eye_rays_, i, side, filter, shading).color;
      sum += color;
      squares += color * color;
    }
    count = n;
    const glm::dvec4 spread = squares - sum * sum / static_cast<double>(n);
    const double variance =
        ((spread.r + spread.g + spread.b) / 3 + kPriorRays * expected) / (n - 1 + kPriorRays);
    const double worth = options_.contrast * options_.contrast / 144;
    // Written so that what is no number ends it.
    if (2 * n > options_.most_rays || !(variance > worth * n * n * std::sqrt(n)))
      return {sum / static_cast<double>(n), n, variance / (n * std::sqrt(n))};
  }
}

RefinementCounts RefinedRows::counts() const {
  RefinementCounts counts = counts_;
  counts.bytes = samples_.bytes() + (above_.colors.capacity() + row_.colors.capacity()) *
                                        (sizeof(glm::dvec4) + sizeof(glm::dvec3));
  return counts;
}

}  // namespace sweepkit::render
