// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace sweepkit::scene {

/// How the mirrored and the refracted share depend on the angle.
enum class Fresnel {
  kNone,     ///< not at all: `reflect` and `transmit` as they are; total reflection mirrors both
  kSchlick,  ///< reflect F and transmit (1 - F), F by Schlick's polynomial
  kExact,    ///< the same, F by Fresnel's equations for unpolarized light
};

/// Whitted's terms. colour = ambient d + sum over lights of V I (d N.L + specular (N.H)^shininess) + reflect
/// R + transmit T, with d = diffuse times the texture.
struct Material {
  std::string name;  ///< empty: the default material
  glm::vec3 diffuse{0.8f};
  std::optional<std::size_t> texture;  ///< index into the textures
  glm::vec3 specular{0.0f};
  float shininess = 50;
  float reflect = 0;
  float transmit = 0;
  float ior = 1;               ///< index of refraction inside the object; outside is air, 1
  glm::vec3 absorption{0.0f};  ///< per metre inside: light is dimmed by exp(-absorption metres)
  Fresnel fresnel = Fresnel::kNone;
  /// Index into the textures, an image. Its RGB times 2, less 1, is a normal in the tangent frame: x where u
  /// grows, y where v grows, z outwards. Normals are made unit after x and y are multiplied by the strength.
  std::optional<std::size_t> normal_map;
  float normal_strength = 1;
};

}  // namespace sweepkit::scene
