// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "sweepkit/scene/material.hpp"

namespace sweepkit::scene {

/// glTF's metallic-roughness terms for Whitted's.
struct GltfMaterial {
  glm::vec3 base_color{0.8f};
  float metallic = 0;
  float roughness = 1;
  std::optional<float> specular_color;  ///< KHR_materials_specular's factor, the same for red, green and blue
};

/// Roughness from the Blinn exponent, alpha = sqrt(2 / (n + 2)) [Walter07] and roughness = sqrt(alpha) (glTF
/// squares it); 1 where there is neither highlight nor mirror. A share reflected besides a diffuse body is a
/// coat of that reflectance, where a dielectric's would be 0.04; a surface that reflects more than it
/// scatters is a metal.
GltfMaterial to_gltf(const Material& material);

}  // namespace sweepkit::scene
