// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_materials.hpp"

#include <algorithm>
#include <cmath>

#include "mean_chord.hpp"

namespace sweepkit::scene {

Material GltfMaterials::material_of(const Object& object) const {
  return object.material ? scene_.materials[*object.material] : Material{};
}

GltfBody GltfMaterials::body_of(const Object& object, double step) {
  if (!plan_.needs_part(Part::kThicknesses)) return {};
  const auto [found, is_new] = thicknesses_.try_emplace(object.mesh);
  if (is_new) {
    const MeshView& mesh = scene_.meshes[object.mesh];
    found->second = mean_chord(mesh);
    result_.ledger[Part::kThicknesses].calls += 1;
    result_.ledger[Part::kThicknesses].bytes += mean_chord_bytes(mesh);
  }
  const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(object.world_from_object))));
  // A viewer scales the thickness as it does the mesh.
  return {found->second ? std::optional(*found->second / step) : std::nullopt, scale * step};
}

GltfMaps GltfMaterials::maps_of(const Object& object, std::vector<texmap::UvTransform>& transforms) {
  const Material material = material_of(object);
  GltfMaps maps;
  if (material.texture && plan_.textures[*material.texture]) {
    const texmap::Texture& source = scene_.textures[*material.texture];
    if (const auto* procedural = std::get_if<texmap::Procedural>(&source)) {
      if (plan_.needs_part(Part::kBakes)) {
        maps.base_color = textures_.baked_texture(object, *procedural, transforms);
      }
    } else {
      maps.base_color = textures_.image_texture(*material.texture);
    }
  }
  if (material.normal_map && plan_.needs_part(Part::kNormalMaps)) {
    // A texture that was baked over the mesh has (u,v) of its own there.
    maps.normals = {textures_.image_texture(*material.normal_map), material.normal_strength,
                    transforms.empty() ? 0 : 1};
  }
  return maps;
}

int GltfMaterials::add(const Object& object, const GltfMaps& maps, double step) {
  const Material material = material_of(object);
  const GltfBody body = material.transmit > 0 ? body_of(object, step) : GltfBody{};
  const GltfMaterial terms = to_gltf(material, options_.look, body);
  const auto same = std::find_if(in_use_.begin(), in_use_.end(),
                                 [&](const InUse& one) { return one.terms == terms && one.maps == maps; });
  if (same != in_use_.end()) return static_cast<int>(same - in_use_.begin());
  in_use_.push_back({terms, maps});
  std::string name;
  if (!options_.is_minimal) name = object.material ? material.name : "default";
  model_.materials.push_back(material_entry(name, terms, maps, extensions_));
  return static_cast<int>(in_use_.size()) - 1;
}

}  // namespace sweepkit::scene
