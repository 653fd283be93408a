// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "mesh_accelerator.hpp"
#include "ray.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/scene.hpp"
#include "voxel_grid.hpp"

namespace sweepkit::render {

/// Rays that are traced together: what a packet of a wide accelerator takes.
inline constexpr std::size_t kPacket = 16;

/// An object as rays see it: its mesh, what finds its triangles, and the way between the spaces.
struct TracedObject {
  const scene::MeshView* mesh;
  glm::dmat4 world_from_mesh;  ///< mesh space: the float32 positions as they are stored
  glm::dmat4 mesh_from_world;
  glm::dmat3 normal_to_world;          ///< transposed inverse, for normals
  const MeshAccelerator* accelerator;  ///< none where the mesh has no triangle; objects of one mesh share it
};

/// Finds what rays meet: among the objects by a grid over their boxes, where there are several, and in each
/// object by its own accelerator.
class Tracer {
 public:
  Tracer(const scene::Scene& scene, bool has_global_grid, Accelerator accelerator);

  Hit nearest(const Ray& ray) const;
  /// The same for rays of one origin, ray i into hits[i].
  void nearest(std::span<const Ray> rays, std::span<Hit> hits) const;
  /// Is anything met at 0 < t < end?
  bool is_blocked(const Ray& ray, double end) const;

  const TracedObject& object(std::uint32_t index) const { return objects_[index]; }
  /// By mesh; none where no object shows the mesh.
  const std::vector<std::unique_ptr<const MeshAccelerator>>& accelerators() const { return accelerators_; }
  const VoxelGrid& global_grid() const { return global_; }
  bool has_global_grid() const { return has_global_grid_; }

 private:
  template <class OnObject>
  void for_objects_along(const Ray& ray, double end, OnObject&& on_object) const;

  std::vector<std::unique_ptr<const MeshAccelerator>> accelerators_;
  std::vector<TracedObject> objects_;
  VoxelGrid global_;
  bool has_global_grid_;
};

}  // namespace sweepkit::render
