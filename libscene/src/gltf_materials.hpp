// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gltf_material_entry.hpp"
#include "gltf_textures.hpp"
#include "sweepkit/scene/gltf.hpp"

namespace sweepkit::scene {

/// The model's materials: one for each set of terms and textures in use.
class GltfMaterials {
 public:
  /// `result` gets what thicknesses cost, `extensions` those that a material uses. All that is given must
  /// outlive this.
  GltfMaterials(tinygltf::Model& model, GltfTextures& textures, GltfFile& result,
                std::set<std::string>& extensions, const Scene& scene, const Plan& plan,
                const GltfOptions& options)
      : model_(model),
        textures_(textures),
        result_(result),
        extensions_(extensions),
        scene_(scene),
        plan_(plan),
        options_(options) {}

  /// The textures of an object's material; `transforms` become those of the mesh's (u,v), where the colours
  /// are baked over it.
  GltfMaps maps_of(const Object& object, std::vector<texmap::UvTransform>& transforms);

  /// The index of the object's material with those textures, for a mesh whose positions are told in steps of
  /// `step` of the object's own. How thick glass is does not depend on the mesh: it is the object's own
  /// one's.
  int add(const Object& object, const GltfMaps& maps, double step);

 private:
  struct InUse {
    GltfMaterial terms;
    GltfMaps maps;
  };

  Material material_of(const Object& object) const;
  GltfBody body_of(const Object& object, double step);

  tinygltf::Model& model_;
  GltfTextures& textures_;
  GltfFile& result_;
  std::set<std::string>& extensions_;
  const Scene& scene_;
  const Plan& plan_;
  const GltfOptions& options_;
  std::vector<InUse> in_use_;                                 // as model_.materials
  std::map<std::size_t, std::optional<double>> thicknesses_;  // by mesh
};

}  // namespace sweepkit::scene
