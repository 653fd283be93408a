// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "texel_source.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::texmap {
namespace {

class WholeImage : public TexelSource {
 public:
  explicit WholeImage(std::shared_ptr<const Image> image) : image_(std::move(image)) {}

  int width() const override { return image_->width; }
  int height() const override { return image_->height; }
  bool is_float() const override { return image_->is_float(); }
  std::size_t bytes() const override { return image_->bytes(); }
  void read(const PixelRect& rect, std::span<IntegerTexel> texels) const override {
    copy<std::uint16_t>(rect, texels, 65535);
  }
  void read(const PixelRect& rect, std::span<FloatTexel> texels) const override {
    copy<float>(rect, texels, 1.0f);
  }

 private:
  // Grey is spread over RGB, alpha left out.
  template <class Sample, class Texel>
  void copy(const PixelRect& rect, std::span<Texel> texels, Sample one) const {
    const auto& samples = std::get<std::vector<Sample>>(image_->texels);
    const auto channels = static_cast<std::size_t>(image_->channels);
    const std::size_t green = channels >= 3 ? 1 : 0;
    const std::size_t blue = channels >= 3 ? 2 : 0;
    auto to = texels.begin();
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
      const Sample* from =
          samples.data() + channels * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_->width) +
                                       static_cast<std::size_t>(rect.x));
      int x = 0;
      if constexpr (std::is_same_v<Texel, IntegerTexel> && std::endian::native == std::endian::little) {
        // RGB as they lie, and what follows them covered by the one; the last has nothing to follow it.
        for (; channels >= 3 && x + 1 < rect.width; ++x, from += channels) {
          std::uint64_t texel;
          std::memcpy(&texel, from, sizeof texel);
          *to++ = std::bit_cast<IntegerTexel>(texel | std::uint64_t{0xffff} << 48);
        }
      }
      for (; x < rect.width; ++x, from += channels) *to++ = Texel{from[0], from[green], from[blue], one};
    }
  }

  std::shared_ptr<const Image> image_;
};

}  // namespace

std::shared_ptr<const TexelSource> make_texel_source(std::shared_ptr<const Image> image) {
  return std::make_shared<const WholeImage>(std::move(image));
}

std::size_t bytes_held(const TexelSource& image) {
  return image.bytes();
}

}  // namespace sweepkit::texmap
