// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_textures.hpp"

#include <algorithm>
#include <array>

#include "gltf_arrays.hpp"
#include "sweepkit/scene/bake_over.hpp"

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

int GltfTextures::add_image(const std::shared_ptr<const texmap::Image>& image, const std::string& name) {
  const std::shared_ptr<const std::vector<std::byte>> png = images_.png(image);
  tinygltf::Image entry;
  entry.name = name;
  if (are_separate_) {
    const std::string file = stem_ + "_" + std::to_string(model_.images.size()) + ".png";
    entry.uri = percent_encoded(file);
    result_.files.push_back({file, *png});
  } else {
    entry.mimeType = "image/png";
    entry.bufferView = buffer_.add_view(*png);
  }
  model_.images.push_back(std::move(entry));
  return static_cast<int>(model_.images.size()) - 1;
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
  model_.textures.push_back(texture);
  return static_cast<int>(model_.textures.size()) - 1;
}

int GltfTextures::image_texture(std::size_t index) {
  const auto found = image_textures_.find(index);
  if (found != image_textures_.end()) return found->second;
  const auto& [image, wrap, file] = std::get<texmap::ImageTexture>(scene_.textures[index]);
  return image_textures_[index] = add_texture(add_image(image, scene_.texture_names[index]), wrap);
}

int GltfTextures::baked_texture(const Object& object, const texmap::Procedural& procedural,
                                std::vector<texmap::UvTransform>& transforms) {
  if (texmap::repeats_in_unit_square(procedural)) {
    const StoredImage baked = images_.bake(procedural, options_.bake_size);
    if (baked.is_new) count_bake(*baked.image);
    return add_texture(add_image(baked.image, object.name), texmap::Wrap::kRepeat);
  }
  texmap::BakedTexture baked = bake_over(scene_.meshes[object.mesh], procedural,
                                         {.width = options_.bake_size, .height = options_.bake_size});
  transforms = std::move(baked.transforms);
  count_bake(baked.image);
  const auto image = std::make_shared<const texmap::Image>(std::move(baked.image));
  return add_texture(add_image(image, object.name), texmap::Wrap::kClamp);
}

void GltfTextures::count_bake(const texmap::Image& image) {
  result_.ledger[Part::kBakes].calls += 1;
  result_.ledger[Part::kBakes].bytes += image.bytes();
}

}  // namespace sweepkit::scene
