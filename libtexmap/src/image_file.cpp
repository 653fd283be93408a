// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/image_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "image_module.hpp"
#include "srgb.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/file_image.hpp"

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
  return encode_file(to_file_image(image, {.format = format, .color_space = color_space}));
}

}  // namespace sweepkit::texmap
