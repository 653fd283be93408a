// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Decimating a mesh loses the grid, the seams' (u,v) and the promise of how far off it is; dividing the
// curves again by a larger tolerance keeps all three.

#include "sweepkit/scene/levels.hpp"

#include <algorithm>
#include <cmath>

#include "object_mesh.hpp"

namespace sweepkit::scene {
namespace {

// More triangles than this of the finer level's are not worth a mesh of their own.
constexpr double kMostKept = 2.0 / 3;

bool is_swept(const Piece& piece) {
  return std::holds_alternative<SweepShape>(piece.shape) || std::holds_alternative<RevolveShape>(piece.shape);
}

double diagonal(std::span<const glm::vec3> positions) {
  glm::vec3 low(positions.front());
  glm::vec3 high = low;
  for (const glm::vec3& position : positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  return glm::distance(glm::dvec3(low), glm::dvec3(high));
}

// By that tolerance in the object's own space, where a piece may be scaled.
ObjectEntry coarser(ObjectEntry object, double tolerance) {
  for (Piece& piece : object.pieces) {
    const double stretch = sweep::largest_stretch(glm::dmat3(to_matrix(piece.placement)));
    if (is_swept(piece)) piece.tessellation.tolerance = tolerance / stretch;
  }
  return object;
}

void drop_last_mesh(Model& model) {
  if (!model.scene.meshes.back().tangents.empty()) model.tangents.pop_back();
  model.scene.meshes.pop_back();
  model.meshes.pop_back();
}

}  // namespace

void add_levels(Model& model, const Document& document, const Plan& plan, int levels) {
  Scene& scene = model.scene;
  scene.coarser.resize(document.objects.size());
  for (std::size_t i = 0; i < document.objects.size(); ++i) {
    const ObjectEntry& object = document.objects[i];
    if (std::none_of(object.pieces.begin(), object.pieces.end(), is_swept)) continue;
    if (scene.meshes[i].triangles.empty()) continue;
    const double size = diagonal(scene.meshes[i].positions);
    const std::size_t areas = scene.meshes[i].areas.size();
    auto finer = static_cast<double>(scene.meshes[i].triangles.size());
    for (int level = 1; level <= levels && size > 0; ++level) {
      const double height = std::ldexp(1.0, -level);
      add_mesh_of(coarser(object, size / (kLevelHeight * height)), document, plan, model);
      const auto triangles = static_cast<double>(scene.meshes.back().triangles.size());
      // Colours that are baked over the mesh are laid out area by area, for all levels alike.
      if (triangles > kMostKept * finer || scene.meshes.back().areas.size() != areas) {
        drop_last_mesh(model);
        continue;
      }
      finer = triangles;
      scene.coarser[i].push_back({scene.meshes.size() - 1, height});
    }
  }
}

}  // namespace sweepkit::scene
