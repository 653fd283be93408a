// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Images that are too large to be read whole.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "image_module.hpp"
#include "srgb.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_file.hpp"
#include "temporary_file.hpp"
#include "texel_source.hpp"

namespace sweepkit::texmap {
namespace {

// What the file's samples mean.
struct Decoding {
  std::filesystem::path file;
  int channels;
  bool is_srgb;

  std::size_t green() const { return channels >= 3 ? 1 : 0; }
  std::size_t blue() const { return channels >= 3 ? 2 : 0; }

  template <class Sample>
  void decode(const Sample* samples, const PixelRect& /*rect*/, std::span<IntegerTexel> texels) const {
    constexpr int kTo16Bits = sizeof(Sample) == 1 ? 257 : 1;
    const std::vector<std::uint16_t>* table = is_srgb ? &linear_from_srgb_table() : nullptr;
    const auto light = [&](Sample sample) {
      const auto wide = static_cast<std::uint16_t>(kTo16Bits * sample);
      return table != nullptr ? (*table)[wide] : wide;
    };
    for (IntegerTexel& texel : texels) {
      texel = IntegerTexel{light(samples[0]), light(samples[green()]), light(samples[blue()]), 65535};
      samples += channels;
    }
  }
  void decode(const float* samples, const PixelRect& rect, std::span<FloatTexel> texels) const {
    for (std::size_t i = 0; i < texels.size(); ++i, samples += channels) {
      texels[i] = FloatTexel{samples[0], samples[green()], samples[blue()], 1.0f};
      if (std::all_of(samples, samples + channels, [](float value) { return std::isfinite(value); }))
        continue;
      const int at = static_cast<int>(i);
      throw InputError({.file = file.string()},
                       "has NaN or infinity at pixel (" + std::to_string(rect.x + at % rect.width) + ", " +
                           std::to_string(rect.y + at / rect.width) + "); mend the image");
    }
  }
};

// A tiled file, read through OpenImageIO's own cache.
class TiledFile : public TexelSource {
 public:
  TiledFile(Decoding decoding, const ModuleFile& opened, std::size_t cache_bytes)
      : decoding_(std::move(decoding)), opened_(opened), cache_bytes_(cache_bytes) {}
  ~TiledFile() override { image_module().close(opened_.handle); }
  TiledFile(const TiledFile&) = delete;
  TiledFile& operator=(const TiledFile&) = delete;

  int width() const override { return opened_.width; }
  int height() const override { return opened_.height; }
  bool is_float() const override { return opened_.sample_bytes == 4; }
  std::size_t bytes() const override { return cache_bytes_; }
  void read(const PixelRect& rect, std::span<IntegerTexel> texels) const override {
    if (opened_.sample_bytes == 1) {
      read_as<std::uint8_t>(rect, texels);
    } else {
      read_as<std::uint16_t>(rect, texels);
    }
  }
  void read(const PixelRect& rect, std::span<FloatTexel> texels) const override {
    read_as<float>(rect, texels);
  }

 private:
  template <class Sample, class Texel>
  void read_as(const PixelRect& rect, std::span<Texel> texels) const {
    std::vector<Sample> samples(texels.size() * static_cast<std::size_t>(opened_.channels));
    throw_if_unreadable(
        decoding_.file,
        image_module().read_rect(opened_.handle, {rect.x, rect.y, rect.width, rect.height}, samples.data()));
    decoding_.decode(samples.data(), rect, texels);
  }

  Decoding decoding_;
  ModuleFile opened_;
  std::size_t cache_bytes_;
};

// An image unpacked into a temporary file, texel after texel as they are handed out.
class UnpackedFile : public TexelSource {
 public:
  UnpackedFile(Decoding decoding, int width, int height, bool is_float)
      : decoding_(std::move(decoding)),
        width_(width),
        height_(height),
        is_float_(is_float),
        unpacked_(decoding_.file.string()) {
    const TakeRows take_rows = [](void* context, int first, int count, const void* samples) {
      return static_cast<UnpackedFile*>(context)->take(first, count, samples);
    };
    const std::string problem = image_module().read_rows(decoding_.file.string(), take_rows, this);
    // Exceptions do not cross the module.
    if (failure_) std::rethrow_exception(failure_);
    throw_if_unreadable(decoding_.file, problem);
  }

  int width() const override { return width_; }
  int height() const override { return height_; }
  bool is_float() const override { return is_float_; }
  std::size_t bytes() const override { return 0; }
  void read(const PixelRect& rect, std::span<IntegerTexel> texels) const override { read_as(rect, texels); }
  void read(const PixelRect& rect, std::span<FloatTexel> texels) const override { read_as(rect, texels); }

 private:
  std::string take(int first, int count, const void* samples) {
    try {
      if (is_float_) {
        append<FloatTexel>(first, count, static_cast<const float*>(samples));
      } else {
        append<IntegerTexel>(first, count, static_cast<const std::uint16_t*>(samples));
      }
      return {};
    } catch (...) {
      failure_ = std::current_exception();
      return "stopped";
    }
  }

  template <class Texel, class Sample>
  void append(int first, int count, const Sample* samples) {
    std::vector<Texel> texels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(count));
    decoding_.decode(samples, {0, first, width_, count}, texels);
    unpacked_.append(std::as_bytes(std::span(texels)));
  }

  template <class Texel>
  void read_as(const PixelRect& rect, std::span<Texel> texels) const {
    for (int y = 0; y < rect.height; ++y) {
      const auto row = texels.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(rect.width),
                                      static_cast<std::size_t>(rect.width));
      const std::int64_t first = std::int64_t{rect.y + y} * width_ + rect.x;
      unpacked_.read(first * static_cast<std::int64_t>(sizeof(Texel)), std::as_writable_bytes(row));
    }
  }

  Decoding decoding_;
  int width_;
  int height_;
  bool is_float_;
  TemporaryFile unpacked_;
  std::exception_ptr failure_;
};

}  // namespace

std::shared_ptr<const TexelSource> open_image(const std::filesystem::path& file, ColorSpace color_space,
                                              std::size_t memory) {
  check_image_exists(file);
  const std::size_t cache_bytes = memory / 8;
  ModuleFile opened;
  throw_if_unreadable(file, image_module().open(file.string(), cache_bytes, opened));
  const std::size_t samples = static_cast<std::size_t>(opened.width) *
                              static_cast<std::size_t>(opened.height) *
                              static_cast<std::size_t>(opened.channels);
  const bool is_float = opened.sample_bytes == 4;
  const bool is_small = samples * (is_float ? 4 : 2) <= memory / 4;
  Decoding decoding{file, opened.channels, color_space == ColorSpace::kSrgb};
  if (opened.is_tiled && !is_small)
    return std::make_shared<const TiledFile>(std::move(decoding), opened, cache_bytes);
  image_module().close(opened.handle);
  if (is_small) return make_texel_source(std::make_shared<const Image>(read_image(file, color_space)));
  return std::make_shared<const UnpackedFile>(std::move(decoding), opened.width, opened.height, is_float);
}

}  // namespace sweepkit::texmap
