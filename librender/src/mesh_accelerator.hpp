// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ray.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::render {

/// Finds the triangles of one mesh that rays meet, in the mesh's own space (its float32 positions as they are
/// stored; t counts the same as in the world). Objects that share a mesh share this; `object` is which of
/// them is asked about, as Hit and Ray::leaves() have it.
///
/// Every one finds the same hits to the bit: whatever culls, ShearedRay::meets() decides, and of several hits
/// Hit::is_before() chooses.
class MeshAccelerator {
 public:
  MeshAccelerator() = default;
  MeshAccelerator(const MeshAccelerator&) = delete;
  MeshAccelerator& operator=(const MeshAccelerator&) = delete;
  virtual ~MeshAccelerator() = default;

  /// Makes `best` the first hit of `ray`, where that is before `best`.
  virtual void find_nearest(const Ray& ray, std::uint32_t object, Hit& best) const = 0;
  /// The same for rays of one origin, ray i into best[i].
  virtual void find_nearest(std::span<const Ray> rays, std::uint32_t object, std::span<Hit> best) const {
    for (std::size_t i = 0; i < rays.size(); ++i) find_nearest(rays[i], object, best[i]);
  }
  /// Is anything met at 0 < t < end?
  virtual bool is_blocked(const Ray& ray, std::uint32_t object, double end) const = 0;

  virtual std::size_t bytes() const = 0;
  /// Of a grid of voxels, the numbers of triangles in those that hold any; appended to `counts`. The number
  /// of all voxels is returned.
  virtual std::size_t count_occupancy(std::vector<std::uint32_t>& /*counts*/) const { return 0; }
};

/// What kAuto stands for with this mesh: the sweep hierarchy where it is a grid (docs/algorithms/
/// sweep-hierarchy.md has the measurements), else SEADS. Always one of ours, whose bytes are the same.
Accelerator choose_accelerator(const scene::MeshView& mesh);

/// `mesh` must outlive it. Throws InputError for kEmbree in a build without it. Precondition: the mesh has
/// triangles, and `kind` is not kAuto.
std::unique_ptr<const MeshAccelerator> make_accelerator(const scene::MeshView& mesh, Accelerator kind);

}  // namespace sweepkit::render
