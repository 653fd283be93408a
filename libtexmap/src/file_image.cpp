// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// From linear light to the numbers of a file. The curve is IEC 61966-2-1's in double: of all levels the
// nearest is taken, by the curve itself and not by a table of it.

#include "sweepkit/texmap/file_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image_module.hpp"
#include "srgb.hpp"

namespace sweepkit::texmap {
namespace {

constexpr float kLargestHalf = 65504;

template <class Sample>
Sample to_level(double value) {
  constexpr double kMost = std::numeric_limits<Sample>::max();
  const double clamped = value > 0 ? std::min(value, 1.0) : 0.0;  // NaN is 0
  return static_cast<Sample>(std::lround(kMost * clamped));
}

template <class Sample>
Sample to_srgb_level(double value) {
  return to_level<Sample>(value > 0 ? srgb_from_linear(std::min(value, 1.0)) : 0.0);
}

// 16-bit linear light to sRGB.
template <class Sample>
std::vector<Sample> make_srgb_table() {
  std::vector<Sample> table(65536);
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = to_srgb_level<Sample>(static_cast<double>(i) / 65535);
  return table;
}

// The first `kept` channels of each texel.
template <class Sample>
std::vector<Sample> to_levels(const Image& image, std::size_t kept, bool is_srgb) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const auto texels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const std::size_t colors = is_srgb ? channels - (channels % 2 == 0 ? 1 : 0) : 0;  // by the curve
  std::vector<Sample> levels;
  levels.reserve(texels * kept);
  const auto fill = [&](const auto& values, auto&& curve, auto&& straight) {
    for (std::size_t texel = 0; texel < texels; ++texel) {
      for (std::size_t k = 0; k < kept; ++k) {
        const auto value = values[texel * channels + k];
        levels.push_back(k < colors ? curve(value) : straight(value));
      }
    }
  };
  if (const auto* floats = std::get_if<std::vector<float>>(&image.texels)) {
    fill(
        *floats, [](float value) { return to_srgb_level<Sample>(static_cast<double>(value)); },
        [](float value) { return to_level<Sample>(static_cast<double>(value)); });
  } else {
    static const std::vector<Sample> table = make_srgb_table<Sample>();
    fill(
        std::get<std::vector<std::uint16_t>>(image.texels), [](std::uint16_t value) { return table[value]; },
        [](std::uint16_t value) { return to_level<Sample>(value / 65535.0); });
  }
  return levels;
}

// What is brighter than the largest number would be written as infinity, which no reader takes.
float within(float value, float largest) {
  return std::isnan(value) ? 0.0f : std::clamp(value, -largest, largest);
}

std::vector<std::string> color_names(int channels) {
  std::vector<std::string> names =
      channels <= 2 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
  if (channels % 2 == 0) names.emplace_back("A");
  return names;
}

// Colours first, then the layers, texel by texel.
std::vector<float> to_floats(const Image& image, const FileEncoding& encoding, std::size_t channels) {
  const float largest = encoding.bits == 32 ? std::numeric_limits<float>::max() : kLargestHalf;
  const auto own = static_cast<std::size_t>(image.channels);
  const auto texels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  std::vector<float> values(texels * channels);
  for (std::size_t texel = 0; texel < texels; ++texel) {
    float* out = values.data() + texel * channels;
    if (const auto* floats = std::get_if<std::vector<float>>(&image.texels)) {
      for (std::size_t k = 0; k < own; ++k) *out++ = within((*floats)[texel * own + k], largest);
    } else {
      const auto& integers = std::get<std::vector<std::uint16_t>>(image.texels);
      for (std::size_t k = 0; k < own; ++k) *out++ = static_cast<float>(integers[texel * own + k] / 65535.0);
    }
    for (const ImageLayer& layer : encoding.layers) {
      const auto& floats = std::get<std::vector<float>>(layer.image->texels);
      const auto count = static_cast<std::size_t>(layer.image->channels);
      for (std::size_t k = 0; k < count; ++k)
        *out++ = within(floats[texel * count + k], std::numeric_limits<float>::max());
    }
  }
  return values;
}

}  // namespace

bool holds_bits(ImageFormat format, int bits) {
  switch (format) {
    case ImageFormat::kPng:
    case ImageFormat::kTiff:
      return bits == 8 || bits == 16;
    case ImageFormat::kJpeg:
      return bits == 8;
    case ImageFormat::kExr:
      return bits == 16 || bits == 32;
  }
  return false;
}

FileImage to_file_image(const Image& image, const FileEncoding& encoding) {
  const bool is_exr = encoding.format == ImageFormat::kExr;
  FileImage file;
  file.width = image.width;
  file.height = image.height;
  file.format = encoding.format;
  file.is_srgb = encoding.color_space == ColorSpace::kSrgb && !is_exr;
  const int bits = encoding.bits != 0 ? encoding.bits : is_exr ? 16 : 8;
  for (std::string& name : color_names(image.channels)) file.channels.push_back({std::move(name), bits});
  if (is_exr) {
    for (const ImageLayer& layer : encoding.layers) {
      for (const std::string& name : layer.channels) file.channels.push_back({name, 32});
    }
    file.samples = to_floats(image, encoding, file.channels.size());
    return file;
  }
  if (encoding.format == ImageFormat::kJpeg && image.channels % 2 == 0) file.channels.pop_back();
  if (bits == 8) {
    file.samples = to_levels<std::uint8_t>(image, file.channels.size(), file.is_srgb);
  } else {
    file.samples = to_levels<std::uint16_t>(image, file.channels.size(), file.is_srgb);
  }
  return file;
}

std::vector<std::byte> encode_file(const FileImage& image) {
  std::vector<std::byte> encoded;
  const std::string problem = image_module().encode(image, encoded);
  throw_if_not_encoded(problem);
  return encoded;
}

FileImage read_file_image(const std::filesystem::path& file) {
  check_image_exists(file);
  FileImage read;
  const std::string problem = image_module().read_file(file.string(), read);
  throw_if_unreadable(file, problem);
  return read;
}

std::string read_description(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return {};
  ModuleInfo info;
  return image_module().read_info(file.string(), info).empty() ? info.description : std::string();
}

}  // namespace sweepkit::texmap
