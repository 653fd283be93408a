// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/scene/material.hpp"

namespace sweepkit::scene {

/// glTF's metallic-roughness terms for Whitted's.
struct GltfMaterial {
  glm::vec3 base_color{0.8f};
  float metallic = 0;
  float roughness = 1;
};

/// Roughness from the Blinn exponent, alpha = sqrt(2 / (n + 2)) and roughness = sqrt(alpha) (Walter et al.
/// 2007 for the first, glTF's own squaring for the second); 1 where there is no highlight. A surface that
/// mirrors more than it scatters becomes a metal of that reflectance.
GltfMaterial to_gltf(const Material& material);

}  // namespace sweepkit::scene
