// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "box_tree.hpp"
#include "mesh_accelerator.hpp"
#include "sweep_kernels.hpp"

namespace sweepkit::render {

/// An implicit hierarchy of boxes over the (u,v) grids of a sweep mesh: built without a search in one pass
/// over the vertices, at 1 to 2 bytes a triangle, and searched in SIMD. A mesh of other triangles has one
/// too, which is neither as quick nor as small. docs/algorithms/sweep-hierarchy.md tells how it works.
class SweepHierarchy final : public MeshAccelerator {
 public:
  /// With the best instruction set of this machine.
  explicit SweepHierarchy(const scene::MeshView& mesh);
  /// With one of instruction_sets().
  SweepHierarchy(const scene::MeshView& mesh, const std::string& instruction_set);

  void find_nearest(const Ray& ray, std::uint32_t object, Hit& best) const override;
  void find_nearest(std::span<const Ray> rays, std::uint32_t object, std::span<Hit> best) const override;
  bool is_blocked(const Ray& ray, std::uint32_t object, double end) const override;
  std::size_t bytes() const override { return tree_.bytes(); }

  const BoxTree& tree() const { return tree_; }

 private:
  const scene::MeshView& mesh_;
  SweepKernels kernels_;
  BoxTree tree_;
};

}  // namespace sweepkit::render
