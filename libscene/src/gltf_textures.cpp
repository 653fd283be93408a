// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_textures.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include "gltf_arrays.hpp"
#include "image_header.hpp"
#include "sweepkit/scene/bake_over.hpp"
#include "sweepkit/scene/texel_density.hpp"

namespace sweepkit::scene {

GltfTextures::GltfTextures(tinygltf::Model& model, GltfBuffer& buffer, GltfFile& result, const Scene& scene,
                           const GltfOptions& options, std::string stem, bool are_separate)
    : model_(model),
      buffer_(buffer),
      result_(result),
      scene_(scene),
      options_(options),
      stem_(std::move(stem)),
      are_separate_(are_separate),
      images_(options.images != nullptr ? *options.images : own_images_) {}

int GltfTextures::add_image(const Bytes& file, bool is_jpeg, const std::string& name) {
  const std::string_view text(reinterpret_cast<const char*>(file->data()), file->size());
  const std::size_t hash = std::hash<std::string_view>()(text);
  for (auto [one, end] = written_.equal_range(hash); one != end; ++one) {
    if (*one->second.first == *file) return one->second.second;
  }
  const int index = static_cast<int>(model_.images.size());
  written_.emplace(hash, std::pair(file, index));
  tinygltf::Image entry;
  if (!options_.is_minimal) entry.name = name;
  if (are_separate_) {
    const std::string beside = stem_ + "_" + std::to_string(index) + (is_jpeg ? ".jpg" : ".png");
    entry.uri = percent_encoded(beside);
    result_.files.push_back({beside, *file});
  } else {
    entry.mimeType = is_jpeg ? "image/jpeg" : "image/png";
    entry.bufferView = buffer_.add_view(*file);
  }
  model_.images.push_back(std::move(entry));
  return index;
}

int GltfTextures::add_encoded(const std::shared_ptr<const texmap::Image>& image, const std::string& name,
                              bool is_normal_map) {
  const texmap::ImageFormat format = options_.image_format.value_or(texmap::ImageFormat::kPng);
  return add_image(images_.encoded(image, {format, options_.max_texture, is_normal_map}),
                   format == texmap::ImageFormat::kJpeg, name);
}

bool GltfTextures::is_normal_map(std::size_t texture) const {
  return std::ranges::any_of(scene_.materials,
                             [&](const Material& material) { return material.normal_map == texture; });
}

// glTF's colours are sRGB, and viewers know PNG and JPEG. A JPEG for printing or one that Exif turns is shown
// in one way here and in another there.
GltfTextures::Bytes GltfTextures::unchanged(std::size_t texture) {
  if (texture >= scene_.texture_sources.size()) return nullptr;
  const ImageSource& source = scene_.texture_sources[texture];
  const auto fitting = is_normal_map(texture) ? texmap::ColorSpace::kLinear : texmap::ColorSpace::kSrgb;
  if (source.file.empty() || source.color_space != fitting) return nullptr;
  std::string ending = source.file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  if (ending != ".png" && ending != ".jpg" && ending != ".jpeg") return nullptr;
  Bytes bytes = images_.file_bytes(source.file);
  const std::optional<ImageHeader> header = image_header(*bytes);
  if (!header || (options_.max_texture > 0 && std::max(header->width, header->height) > options_.max_texture))
    return nullptr;
  const auto format = header->is_jpeg ? texmap::ImageFormat::kJpeg : texmap::ImageFormat::kPng;
  if (options_.image_format.value_or(format) != format) return nullptr;
  if (header->is_jpeg && (header->orientation != 1 || (header->components != 1 && header->components != 3)))
    return nullptr;
  return bytes;
}

int GltfTextures::add_texture(int image, texmap::Wrap wrap) {
  tinygltf::Sampler sampler;
  sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
  sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
  static constexpr std::array kModes = {TINYGLTF_TEXTURE_WRAP_REPEAT, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE,
                                        TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT};  // by Wrap
  sampler.wrapS = sampler.wrapT = kModes[static_cast<std::size_t>(wrap)];
  const auto same = std::find(model_.samplers.begin(), model_.samplers.end(), sampler);
  tinygltf::Texture texture;
  texture.source = image;
  texture.sampler = static_cast<int>(same - model_.samplers.begin());
  if (same == model_.samplers.end()) model_.samplers.push_back(sampler);
  const auto known = std::find(model_.textures.begin(), model_.textures.end(), texture);
  const auto index = static_cast<int>(known - model_.textures.begin());
  if (known == model_.textures.end()) model_.textures.push_back(texture);
  return index;
}

int GltfTextures::image_texture(std::size_t index) {
  const auto found = image_textures_.find(index);
  if (found != image_textures_.end()) return found->second;
  const auto& [image, wrap, file] = std::get<texmap::ImageTexture>(scene_.textures[index]);
  const std::string& name = scene_.texture_names[index];
  const Bytes bytes = unchanged(index);
  const int entry = bytes ? add_image(bytes, image_header(*bytes)->is_jpeg, name)
                          : add_encoded(image, name, is_normal_map(index));
  return image_textures_[index] = add_texture(entry, wrap);
}

int GltfTextures::baked_texture(const Object& object, const texmap::Procedural& procedural,
                                std::vector<texmap::UvTransform>& transforms) {
  BakeSize wanted{.size = options_.bake_size, .density = options_.texel_density};
  if (options_.max_texture > 0) {
    wanted.size = std::min(wanted.size, options_.max_texture);
    wanted.most = std::min(wanted.most, options_.max_texture);
  }
  const MeshView& mesh = scene_.meshes[object.mesh];
  const glm::ivec2 size = bake_size_of(mesh, glm::dmat3(object.world_from_object), procedural, wanted);
  if (texmap::repeats_in_unit_square(procedural)) {
    const StoredImage baked = images_.bake(procedural, size, options_.threads);
    if (baked.is_new) count_bake(*baked.image);
    return add_texture(add_encoded(baked.image, object.name), texmap::Wrap::kRepeat);
  }
  texmap::BakedTexture baked = bake_over(mesh, procedural, {size.x, size.y, options_.threads});
  transforms = std::move(baked.transforms);
  count_bake(baked.image);
  const auto image = std::make_shared<const texmap::Image>(std::move(baked.image));
  return add_texture(add_encoded(image, object.name), texmap::Wrap::kClamp);
}

void GltfTextures::count_bake(const texmap::Image& image) {
  result_.ledger[Part::kBakes].calls += 1;
  result_.ledger[Part::kBakes].bytes += image.bytes();
}

}  // namespace sweepkit::scene
