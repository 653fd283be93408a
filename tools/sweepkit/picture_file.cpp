// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "picture_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>

namespace sweepkit::tools {
namespace {

using texmap::ImageFormat;

std::string layer_file(const std::string& file, render::Layer layer) {
  std::string name = std::filesystem::path(file).replace_extension().string();
  for (const std::string_view part :
       {std::string_view("."), render::kind_of(layer).name, std::string_view(".exr")})
    name += part;
  return name;
}

// Exposed, and divided by alpha where there is one and the format has it so.
void finish_colors(texmap::Image& image, const PictureEncoding& encoding) {
  const bool is_divided = image.channels == 4 && encoding.format != ImageFormat::kExr;
  if (encoding.exposure == 0 && !is_divided) return;
  constexpr double kMost = std::numeric_limits<float>::max();
  const double gain = std::exp2(encoding.exposure);
  auto& texels = std::get<std::vector<float>>(image.texels);
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t at = 0; at < texels.size(); at += channels) {
    const double alpha = is_divided ? static_cast<double>(texels[at + 3]) : 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = alpha > 0 ? gain * static_cast<double>(texels[at + k]) / alpha : 0;
      texels[at + k] = static_cast<float>(std::clamp(value, -kMost, kMost));
    }
  }
}

texmap::ImageLayer named(const render::PictureLayer& layer) {
  const auto& channels = render::kind_of(layer.layer).channels;
  return {{channels.begin(), channels.end()}, &layer.image};
}

// One layer as a file of its own, with the names that it has as a part of a picture's.
texmap::FileImage layer_image(const render::PictureLayer& layer) {
  texmap::FileImage file = to_file_image(layer.image, {.format = ImageFormat::kExr, .bits = 32});
  file.channels.clear();
  for (std::string& name : named(layer).channels) file.channels.push_back({std::move(name), 32});
  return file;
}

}  // namespace

std::vector<std::string> picture_file_names(const std::string& file, ImageFormat format,
                                            const std::vector<render::Layer>& layers) {
  std::vector<std::string> names = {file};
  if (format == ImageFormat::kExr) return names;
  names.reserve(1 + layers.size());
  for (const render::Layer layer : layers) names.push_back(layer_file(file, layer));
  return names;
}

std::vector<EncodedFile> encode_picture(render::Picture picture, const std::string& file,
                                        const PictureEncoding& encoding, const std::string& description) {
  finish_colors(picture.image, encoding);
  std::vector<texmap::ImageLayer> layers;
  layers.reserve(picture.layers.size());
  const bool is_exr = encoding.format == ImageFormat::kExr;
  for (const render::PictureLayer& layer : picture.layers) {
    if (is_exr) layers.push_back(named(layer));
  }
  std::vector<EncodedFile> files;
  const auto add = [&](std::string name, texmap::FileImage image) {
    image.window = encoding.window;
    image.description = description;
    files.push_back({std::move(name), encode_file(image)});
  };
  add(file,
      to_file_image(picture.image, {.format = encoding.format, .bits = encoding.bits, .layers = layers}));
  if (is_exr) return files;
  for (const render::PictureLayer& layer : picture.layers)
    add(layer_file(file, layer.layer), layer_image(layer));
  return files;
}

}  // namespace sweepkit::tools
