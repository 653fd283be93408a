// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <optional>
#include <set>
#include <string>

#include "gltf_material.hpp"

namespace sweepkit::scene {

/// A texture as a normal map, by which of the mesh's (u,v).
struct GltfNormalMap {
  int texture = 0;
  float scale = 1;
  int texcoord = 0;

  bool operator==(const GltfNormalMap&) const = default;
};

/// The model's textures that a material has.
struct GltfMaps {
  std::optional<int> base_color;
  std::optional<GltfNormalMap> normals;

  bool operator==(const GltfMaps&) const = default;
};

/// The terms as an entry of the file, with their textures. Adds to `extensions` those that it uses.
tinygltf::Material material_entry(const std::string& name, const GltfMaterial& terms, const GltfMaps& maps,
                                  std::set<std::string>& extensions);

}  // namespace sweepkit::scene
