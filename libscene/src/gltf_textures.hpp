// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "gltf_buffer.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/image_store.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/bake.hpp"

namespace sweepkit::scene {

/// The model's images, samplers and textures. Each is written once for all that use it.
class GltfTextures {
 public:
  /// `result` gets the images that stand beside the file, named for `stem`, and the bakes' costs. All that is
  /// given must outlive this.
  GltfTextures(tinygltf::Model& model, GltfBuffer& buffer, GltfFile& result, const Scene& scene,
               const GltfOptions& options, std::string stem, bool are_separate);

  /// An image texture of the scene: its index in the model. A material's normal map keeps its numbers as they
  /// are, where colours become sRGB.
  int image_texture(std::size_t index);
  /// A procedural texture as it lies on that surface. `transforms` become those of the mesh's (u,v), empty
  /// for the identity.
  int baked_texture(const Object& object, const texmap::Procedural& procedural,
                    std::vector<texmap::UvTransform>& transforms);

 private:
  using Bytes = std::shared_ptr<const std::vector<std::byte>>;

  int add_texture(int image, texmap::Wrap wrap);
  /// One for images of equal bytes.
  int add_image(const Bytes& file, bool is_jpeg, const std::string& name);
  int add_encoded(const std::shared_ptr<const texmap::Image>& image, const std::string& name,
                  bool is_normal_map = false);
  /// The file itself, if it may stand in a glTF as it is.
  Bytes unchanged(std::size_t texture);
  bool is_normal_map(std::size_t texture) const;
  void count_bake(const texmap::Image& image);

  tinygltf::Model& model_;
  GltfBuffer& buffer_;
  GltfFile& result_;
  const Scene& scene_;
  const GltfOptions& options_;
  std::string stem_;
  bool are_separate_;
  ImageStore own_images_;  // where the caller has none
  ImageStore& images_;
  std::map<std::size_t, int> image_textures_;
  std::unordered_multimap<std::size_t, std::pair<Bytes, int>> written_;  // by hash: bytes and image
};

}  // namespace sweepkit::scene
