// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "sweepkit/texmap/filter.hpp"
#include "sweepkit/texmap/footprint.hpp"
#include "sweepkit/texmap/texture.hpp"
#include "sweepkit/texmap/tile_cache.hpp"

namespace sweepkit::texmap {

struct FilterScratch;

/// What one thread needs while it filters: scratch memory and the tiles that it read last.
class FilterThread {
 public:
  explicit FilterThread(TileCache& cache);
  ~FilterThread();
  FilterThread(FilterThread&&) noexcept;

 private:
  friend class TextureSampler;
  std::unique_ptr<FilterScratch> scratch_;
};

/// An image texture made ready for one filter: what that filter reads is made, nothing else. Lookups from any
/// number of threads, each with a FilterThread of its own over the same cache; a lookup's result does not
/// depend on the others.
class TextureSampler {
 public:
  /// `id` sets the texture's tiles apart from others in the same cache.
  TextureSampler(const ImageTexture& texture, Filter filter, TileCache& cache, std::uint32_t id);
  ~TextureSampler();
  TextureSampler(TextureSampler&&) noexcept;

  /// The texture under the footprint, linear RGB. Any footprint: one without area is as wide as a texel, one
  /// that is not finite gives the mean of the texture.
  glm::vec3 sample(const Footprint& footprint, FilterThread& thread) const;

  /// The filter with a box as its support: n boxes of an n-th of it, for order 1 its mean. A box narrower
  /// than a texel is widened to about one; one that is not finite gives the mean of the texture.
  /// Precondition: reads_table(filter).
  glm::vec3 over_box(const UvBox& box, FilterThread& thread) const;

  /// Memory held besides tiles, once no lookup is going on.
  std::size_t table_bytes() const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace sweepkit::texmap
