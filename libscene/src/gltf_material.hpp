// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/material.hpp"

namespace sweepkit::scene {

/// KHR_materials_volume's terms. Light over a distance x inside is left attenuation_color^(x /
/// attenuation_distance).
struct GltfVolume {
  float thickness = 0;             ///< metres in the mesh's space, by mean_chord()
  float attenuation_distance = 0;  ///< metres in the world; 0: nothing is absorbed
  glm::vec3 attenuation_color{1.0f};

  bool operator==(const GltfVolume&) const = default;
};

/// glTF's terms for Whitted's. What is none stays out of the file.
struct GltfMaterial {
  glm::vec3 base_color{0.8f};
  float alpha = 1;  ///< under 1 it is blended with what is behind
  float metallic = 0;
  float roughness = 1;
  std::optional<float> specular;            ///< KHR_materials_specular's factor
  std::optional<glm::vec3> specular_color;  ///< its colour's
  std::optional<float> ior;                 ///< KHR_materials_ior
  float transmission = 0;                   ///< KHR_materials_transmission
  std::optional<GltfVolume> volume;
  bool is_unlit = false;        ///< KHR_materials_unlit
  bool is_double_sided = true;  ///< a ray sees both sides of a surface; of closed glass the front is enough

  bool operator==(const GltfMaterial&) const = default;
};

/// What is known of the body that a material which transmits fills.
struct GltfBody {
  std::optional<double> thickness;  ///< mean_chord(); none: the surface is open
  double scale = 1;                 ///< world from mesh
};

/// With n for shininess, d diffuse, r reflect, t transmit, sigma absorption (docs/gltf.md derives them):
///   highlight   roughness = (2 / (n + 2))^(1/4): alpha = sqrt(2 / (n + 2)) [Walter07], which glTF squares;
///               1 without highlight or mirror. Without a mirror its height is Whitted's: a mirror of
///               8 specular / (n + 2) of each colour, at most 1
///   mirror      r > d: metallic 1, base colour r. Else metallic 0, base colour d, and r at right angles by
///               KHR_materials_specular: colour r / F0, where F0 = ((ior - 1) / (ior + 1))^2, 0.04 unless
///               said. By Fresnel: factor r, and KHR_materials_ior. Roughness 0 without a highlight; else
///               such that the highlight is as wide as Whitted's where that is half as high as in its
///               middle, at most 0.25
///   glass       base colour d + t, transmission t / (t + mean d): what is scattered comes to d and what goes
///               through to t where d is grey. Roughness 0
///   volume      of closed glass that refracts or absorbs: attenuation distance D = 1 / max sigma,
///               colour exp(-sigma D)
/// GltfLook::kUnlit and kCompatible blend glass instead: over greys it looks as Whitted's does, as nearly as
/// one alpha can; a wall of a body stands for the one behind it as well.
GltfMaterial to_gltf(const Material& material, GltfLook look = GltfLook::kFull, const GltfBody& body = {});

}  // namespace sweepkit::scene
