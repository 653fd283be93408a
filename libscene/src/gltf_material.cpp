// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// [Walter07] B. Walter, S. Marschner, H. Li, K. Torrance, "Microfacet models for refraction through rough
// surfaces" (2007), for the width of a microfacet lobe that looks like a Blinn exponent n. A mirror of
// Whitted's is perfectly sharp and its highlight is not; glTF has one roughness for both, so the sharper of
// two guesses is taken.

#include "gltf_material.hpp"

#include <algorithm>
#include <cmath>

namespace sweepkit::scene {

GltfMaterial to_gltf(const Material& material) {
  const glm::vec3 diffuse = glm::clamp(material.diffuse, 0.0f, 1.0f);
  const float reflect = std::clamp(material.reflect, 0.0f, 1.0f);
  if (reflect > std::max({diffuse.r, diffuse.g, diffuse.b})) return {glm::vec3(reflect), 1, 0, {}};
  const bool has_highlight = material.specular != glm::vec3(0.0f);
  const float roughness = has_highlight ? std::pow(2 / (material.shininess + 2), 0.25f) : 1.0f;
  if (reflect == 0) return {diffuse, 0, roughness, {}};
  constexpr float kSharp = 0.25f;  // a reflection that can still be read
  constexpr float kDielectric = 0.04f;
  return {diffuse, 0, std::min(roughness, kSharp), reflect / kDielectric};
}

}  // namespace sweepkit::scene
