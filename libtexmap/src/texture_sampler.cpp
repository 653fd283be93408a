// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/texture_sampler.hpp"

#include <optional>

#include "elliptical_average.hpp"
#include "filter_scratch.hpp"
#include "mip_filter.hpp"
#include "parallelogram_average.hpp"
#include "pyramid.hpp"
#include "repeated_integration.hpp"

namespace sweepkit::texmap {
namespace {

int order_of(Filter filter) {
  return 1 + static_cast<int>(filter) - static_cast<int>(Filter::kIntegral1);
}

}  // namespace

FilterThread::FilterThread(TileCache& cache) : scratch_(std::make_unique<FilterScratch>(cache)) {}
FilterThread::~FilterThread() = default;
FilterThread::FilterThread(FilterThread&&) noexcept = default;

struct TextureSampler::Prepared {
  ImageTexture texture;
  Filter filter;
  std::optional<Pyramid> pyramid;
  std::optional<RepeatedIntegration> integrals;
};

TextureSampler::TextureSampler(const ImageTexture& texture, Filter filter, TileCache& cache,
                               std::uint32_t id) {
  auto prepared = std::make_unique<Prepared>();
  prepared->texture = texture;
  prepared->filter = filter;
  prepared->pyramid.emplace(texture.file ? texture.file : make_texel_source(texture.image), cache, id);
  if (reads_table(filter))
    prepared->integrals.emplace(*prepared->pyramid, texture.wrap, order_of(filter), cache, id);
  prepared_ = std::move(prepared);
}
TextureSampler::~TextureSampler() = default;
TextureSampler::TextureSampler(TextureSampler&&) noexcept = default;

glm::vec3 TextureSampler::sample(const Footprint& footprint, FilterThread& thread) const {
  const Wrap wrap = prepared_->texture.wrap;
  switch (prepared_->filter) {
    case Filter::kPoint:
      return nearest_texel(*prepared_->pyramid, wrap, footprint.uv, thread.scratch_->tiles);
    case Filter::kBilinear:
      return bilinear(*prepared_->pyramid, wrap, footprint.uv, thread.scratch_->tiles);
    case Filter::kTrilinear:
      return trilinear(*prepared_->pyramid, wrap, footprint, thread.scratch_->tiles);
    case Filter::kIntegral1:
    case Filter::kIntegral2:
    case Filter::kIntegral3:
      return prepared_->integrals->over_pixel(footprint, *thread.scratch_);
    case Filter::kEwa:
      return elliptical_average(*prepared_->pyramid, wrap, footprint, Detail::kFull, *thread.scratch_);
    case Filter::kBox:
      if (const auto mean = parallelogram_average(*prepared_->pyramid, wrap, footprint, *thread.scratch_))
        return *mean;
      break;
    case Filter::kAuto:
      break;
  }
  const glm::dvec2 size(prepared_->pyramid->level(0).width, prepared_->pyramid->level(0).height);
  const glm::dvec2 steps = (glm::abs(footprint.dx) + glm::abs(footprint.dy)) * size;
  if (steps.x < 1 && steps.y < 1)
    return bilinear(*prepared_->pyramid, wrap, footprint.uv, thread.scratch_->tiles);
  return elliptical_average(*prepared_->pyramid, wrap, footprint, Detail::kBalanced, *thread.scratch_);
}

glm::vec3 TextureSampler::over_box(const UvBox& box, FilterThread& thread) const {
  return prepared_->integrals->over_box(box, *thread.scratch_);
}

std::size_t TextureSampler::table_bytes() const {
  return prepared_->integrals ? prepared_->integrals->bytes() : 0;
}

}  // namespace sweepkit::texmap
