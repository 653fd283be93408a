// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ray.hpp"
#include "sweepkit/scene/scene.hpp"
#include "voxel_grid.hpp"

namespace sweepkit::render {

/// An object as rays see it: its mesh, its own grid in mesh space, and the way between the spaces.
struct TracedObject {
  const scene::MeshView* mesh;
  glm::dmat4 world_from_mesh;  ///< mesh space: the float32 positions as they are stored
  glm::dmat4 mesh_from_world;
  glm::dmat3 normal_to_world;  ///< transposed inverse, for normals
  VoxelGrid grid;
};

/// Finds what rays meet. Grids as in the paper's 3.3: one over each object, its voxels sized so that about
/// six triangles lie in one, and one over the objects' boxes where there are several. Or, for comparison,
/// every triangle of every object.
class Tracer {
 public:
  enum class Search { kGrids, kLinear };

  Tracer(const scene::Scene& scene, bool has_global_grid, Search search);

  Hit nearest(const Ray& ray) const;
  /// Is anything met at 0 < t < end?
  bool is_blocked(const Ray& ray, double end) const;

  const TracedObject& object(std::uint32_t index) const { return objects_[index]; }
  std::size_t object_count() const { return objects_.size(); }
  const VoxelGrid& global_grid() const { return global_; }
  bool has_global_grid() const { return has_global_grid_; }

 private:
  template <class OnObject>
  void for_objects_along(const Ray& ray, double end, OnObject&& on_object) const;

  std::vector<TracedObject> objects_;
  VoxelGrid global_;
  bool has_global_grid_;
  Search search_;
};

}  // namespace sweepkit::render
