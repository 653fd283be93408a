// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace sweepkit::scene {

/// Whitted's terms. colour = ambient d + sum over lights of V I (d N.L + specular (N.H)^shininess) + reflect
/// R, with d = diffuse times the texture.
struct Material {
  std::string name;  ///< empty: the default material
  glm::vec3 diffuse{0.8f};
  std::optional<std::size_t> texture;  ///< index into the textures
  glm::vec3 specular{0.0f};
  float shininess = 50;
  float reflect = 0;
};

}  // namespace sweepkit::scene
