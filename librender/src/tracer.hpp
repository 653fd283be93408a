// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "mesh_accelerator.hpp"
#include "object_tree.hpp"
#include "ray.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::render {

/// An object as rays see it: its mesh, what finds its triangles, and the way between the spaces.
struct TracedObject {
  const scene::MeshView* mesh;
  glm::dmat4x3 world_from_mesh;  ///< mesh space: the float32 positions as they are stored
  glm::dmat4x3 mesh_from_world;
  glm::dmat3 normal_to_world;          ///< transposed inverse, for normals
  const MeshAccelerator* accelerator;  ///< none where the mesh has no triangle; objects of one mesh share it
  /// All positions have one coordinate in common. Then a ray that leaves one of its triangles for good leaves
  /// them all.
  bool is_flat = false;

  /// May a ray meet it at all?
  bool can_be_met_by(const Ray& ray, std::uint32_t own_index) const {
    return accelerator != nullptr && !(is_flat && ray.from_object == own_index && ray.from_triangle != kNone);
  }
};

/// Finds what rays meet: among the objects by a tree over their boxes, where there are several, and in each
/// object by its own accelerator.
class Tracer {
 public:
  Tracer(const scene::Scene& scene, bool has_object_tree, Accelerator accelerator);

  Hit nearest(const Ray& ray) const;
  /// The same hits for rays of one origin, ray i into hits[i], for less than one by one. At most
  /// ObjectTree::kMostRays.
  void nearest(std::span<const Ray> rays, std::span<Hit> hits) const;
  /// Is anything met at 0 < t < end?
  bool is_blocked(const Ray& ray, double end) const;

  const TracedObject& object(std::uint32_t index) const { return objects_[index]; }
  /// By mesh; none where no object shows the mesh.
  const std::vector<std::unique_ptr<const MeshAccelerator>>& accelerators() const { return accelerators_; }
  const ObjectTree& object_tree() const { return tree_; }
  bool has_object_tree() const { return has_object_tree_; }

 private:
  std::vector<std::unique_ptr<const MeshAccelerator>> accelerators_;
  std::vector<TracedObject> objects_;
  ObjectTree tree_;
  bool has_object_tree_;
};

}  // namespace sweepkit::render
