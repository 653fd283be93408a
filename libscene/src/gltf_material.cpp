// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_material.hpp"

#include <algorithm>
#include <cmath>

namespace sweepkit::scene {

GltfMaterial to_gltf(const Material& material) {
  const float diffuse = std::max({material.diffuse.r, material.diffuse.g, material.diffuse.b});
  if (material.reflect > diffuse) return {glm::vec3(material.reflect), 1, 0};
  const bool has_highlight = material.specular != glm::vec3(0.0f);
  const float roughness = has_highlight ? std::pow(2.0f / (material.shininess + 2), 0.25f) : 1.0f;
  // A weak mirror over a diffuse body is what a dielectric's smooth coat looks like.
  return {material.diffuse, 0, material.reflect > 0 ? std::min(roughness, 0.25f) : roughness};
}

}  // namespace sweepkit::scene
