// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::scene {

class ImageStore;

/// A Scene together with the meshes its views look at. Moving it keeps the views valid; it is not copied.
struct Model {
  std::vector<std::unique_ptr<const sweep::Mesh>> meshes;  ///< one an object; OpenMesh's cannot be moved
  std::vector<std::vector<glm::vec4>> tangents;  ///< of those meshes that a normal map needs them for
  Scene scene;
  Ledger ledger;               ///< half-edges, textures, tangents
  double mesh_seconds = 0;     ///< that the meshes took to make
  double texture_seconds = 0;  ///< that the textures took to read

  Model() = default;
  Model(Model&&) = default;
  Model& operator=(Model&&) = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
};

/// The largest distance of an object's mesh from its surface in the world, metres; nothing where a part of it
/// was divided by counts.
std::optional<double> deviation_of(const Model& model, const Object& object);

/// Makes the document's meshes and reads the textures that the plan needs. Without a camera the picture
/// frames the scene; a light is added only where lights and ambient are both absent. Images come from
/// `images` where there is a store. Throws InputError with the place of the object or texture at fault.
Model build(const Document& document, const Plan& plan, ImageStore* images = nullptr);

}  // namespace sweepkit::scene
