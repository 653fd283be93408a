// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "mesh_accelerator.hpp"
#include "voxel_grid.hpp"

namespace sweepkit::render {

/// The paper's grid (3.3) over a mesh, in its own space and so oriented to it.
class Seads final : public MeshAccelerator {
 public:
  explicit Seads(const scene::MeshView& mesh);

  using MeshAccelerator::find_nearest;
  void find_nearest(const Ray& ray, std::uint32_t object, Hit& best) const override;
  bool is_blocked(const Ray& ray, std::uint32_t object, double end) const override;
  std::size_t bytes() const override { return grid_.bytes(); }
  std::size_t count_occupancy(std::vector<std::uint32_t>& counts) const override;

 private:
  const scene::MeshView& mesh_;
  VoxelGrid grid_;
};

}  // namespace sweepkit::render
