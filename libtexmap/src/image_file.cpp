// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/image_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "image_module.hpp"
#include "srgb.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::texmap {
namespace {

bool is_alpha(std::size_t channel, int channels) {
  return channels % 2 == 0 && channel + 1 == static_cast<std::size_t>(channels);
}

void decode_srgb(std::vector<std::uint16_t>& samples, int channels) {
  const std::vector<std::uint16_t>& table = linear_from_srgb_table();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!is_alpha(i % static_cast<std::size_t>(channels), channels)) samples[i] = table[samples[i]];
  }
}

std::uint8_t to_byte(double value) {
  const double clamped = value > 0 ? std::min(value, 1.0) : 0.0;  // NaN is 0
  return static_cast<std::uint8_t>(std::lround(255 * clamped));
}

std::uint8_t to_srgb_byte(double value) {
  return to_byte(value > 0 ? srgb_from_linear(std::min(value, 1.0)) : 0.0);
}

// 16-bit linear light to 8-bit sRGB.
std::vector<std::uint8_t> make_srgb_byte_table() {
  std::vector<std::uint8_t> table(65536);
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = to_srgb_byte(static_cast<double>(i) / 65535);
  return table;
}

std::vector<std::uint8_t> to_bytes(const Image& image, bool is_srgb) {
  const auto is_color = [&](std::size_t i) {
    return is_srgb && !is_alpha(i % static_cast<std::size_t>(image.channels), image.channels);
  };
  std::vector<std::uint8_t> bytes;
  if (const auto* floats = std::get_if<std::vector<float>>(&image.texels)) {
    bytes.reserve(floats->size());
    for (std::size_t i = 0; i < floats->size(); ++i) {
      const double value = (*floats)[i];
      bytes.push_back(is_color(i) ? to_srgb_byte(value) : to_byte(value));
    }
    return bytes;
  }
  static const std::vector<std::uint8_t> table = make_srgb_byte_table();
  const auto& integers = std::get<std::vector<std::uint16_t>>(image.texels);
  bytes.reserve(integers.size());
  for (std::size_t i = 0; i < integers.size(); ++i)
    bytes.push_back(is_color(i) ? table[integers[i]] : to_byte(integers[i] / 65535.0));
  return bytes;
}

// Half floats end at 65504: what is brighter would be written as infinity, which no reader takes.
std::vector<float> to_half_range(const Image& image) {
  constexpr float kLargestHalf = 65504;
  std::vector<float> values;
  if (const auto* floats = std::get_if<std::vector<float>>(&image.texels)) {
    values.reserve(floats->size());
    for (const float value : *floats)
      values.push_back(std::isnan(value) ? value : std::clamp(value, -kLargestHalf, kLargestHalf));
    return values;
  }
  const auto& integers = std::get<std::vector<std::uint16_t>>(image.texels);
  values.reserve(integers.size());
  for (const std::uint16_t value : integers) values.push_back(static_cast<float>(value / 65535.0));
  return values;
}

}  // namespace

Image read_image(const std::filesystem::path& file, ColorSpace color_space) {
  check_image_exists(file);
  ModuleImage read;
  const std::string problem = image_module().read(file.string(), read);
  throw_if_unreadable(file, problem);
  Image image{read.width, read.height, read.channels, std::move(read.samples)};
  if (auto* integers = std::get_if<std::vector<std::uint16_t>>(&image.texels)) {
    if (color_space == ColorSpace::kSrgb) decode_srgb(*integers, image.channels);
    return image;
  }
  const auto& floats = std::get<std::vector<float>>(image.texels);
  const auto bad =
      std::find_if_not(floats.begin(), floats.end(), [](float value) { return std::isfinite(value); });
  if (bad != floats.end()) {
    const auto pixel = (bad - floats.begin()) / image.channels;
    throw InputError({.file = file.string()}, "has NaN or infinity at pixel (" +
                                                  std::to_string(pixel % image.width) + ", " +
                                                  std::to_string(pixel / image.width) + "); mend the image");
  }
  return image;
}

ImageFileInfo read_image_info(const std::filesystem::path& file) {
  check_image_exists(file);
  ModuleInfo info;
  const std::string problem = image_module().read_info(file.string(), info);
  throw_if_unreadable(file, problem);
  return {info.width, info.height, info.channels, info.format, info.sample_type};
}

ImageFormat image_format(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".png") return ImageFormat::kPng;
  if (extension == ".jpg" || extension == ".jpeg") return ImageFormat::kJpeg;
  if (extension == ".tif" || extension == ".tiff") return ImageFormat::kTiff;
  if (extension == ".exr") return ImageFormat::kExr;
  throw InputError({.file = file.string()}, "a picture's name ends in .png, .jpg, .tif or .exr");
}

std::vector<std::byte> encode_image(const Image& image, ImageFormat format, ColorSpace color_space) {
  static constexpr const char* kExtensions[] = {"png", "jpg", "tif", "exr"};
  const bool is_exr = format == ImageFormat::kExr;
  const bool is_srgb = color_space == ColorSpace::kSrgb && !is_exr;
  const std::vector<std::uint8_t> bytes = is_exr ? std::vector<std::uint8_t>{} : to_bytes(image, is_srgb);
  const std::vector<float> floats = is_exr ? to_half_range(image) : std::vector<float>{};
  std::vector<std::byte> encoded;
  const std::string problem = image_module().encode(
      {kExtensions[static_cast<std::size_t>(format)], image.width, image.height, image.channels, is_srgb,
       is_exr ? nullptr : bytes.data(), is_exr ? floats.data() : nullptr},
      encoded);
  throw_if_not_encoded(problem);
  return encoded;
}

}  // namespace sweepkit::texmap
