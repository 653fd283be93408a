// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "spline_reference.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"

namespace sweepkit::texmap::test {

/// A texture under a filter of order 1, 2 or 3, with a cache of its own.
class IntegralTexture {
 public:
  IntegralTexture(std::shared_ptr<const Image> image, Wrap wrap, int order,
                  std::size_t memory = kDefaultTextureMemory)
      : image_(std::move(image)),
        order_(order),
        cache_(memory),
        sampler_({image_, wrap}, static_cast<Filter>(static_cast<int>(Filter::kIntegral1) + order - 1),
                 cache_, 0) {}
  IntegralTexture(Image image, Wrap wrap, int order)
      : IntegralTexture(std::make_shared<const Image>(std::move(image)), wrap, order) {}

  const Image& image() const { return *image_; }
  TileCache::Counts counts() const { return cache_.counts(); }
  std::size_t bytes_besides_tiles() const { return sampler_.table_bytes(); }

  glm::vec3 over(const reference::Box& box) {
    const glm::dvec2 size(image_->width, image_->height);
    return over(UvBox{{box.x / size.x, 1 - (box.y + order_ * box.height) / size.y},
                      {(box.x + order_ * box.width) / size.x, 1 - box.y / size.y}});
  }
  glm::vec3 over(const UvBox& box) { return sampler_.over_box(box, thread_); }
  glm::vec3 sample(const Footprint& footprint) { return sampler_.sample(footprint, thread_); }

 private:
  std::shared_ptr<const Image> image_;
  int order_;
  TileCache cache_;
  TextureSampler sampler_;
  FilterThread thread_{cache_};
};

}  // namespace sweepkit::texmap::test
