// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "mesh_accelerator.hpp"

#include "embree_accelerator.hpp"
#include "linear_scan.hpp"
#include "seads.hpp"
#include "sweep_hierarchy.hpp"

namespace sweepkit::render {

Accelerator choose_accelerator(const scene::MeshView& mesh) {
  return mesh.patches.empty() ? Accelerator::kSeads : Accelerator::kSweep;
}

std::unique_ptr<const MeshAccelerator> make_accelerator(const scene::MeshView& mesh, Accelerator kind) {
  if (kind == Accelerator::kLinear) return std::make_unique<LinearScan>(mesh);
  if (kind == Accelerator::kSweep) return std::make_unique<SweepHierarchy>(mesh);
  if (kind == Accelerator::kEmbree) return make_embree_accelerator(mesh);
  return std::make_unique<Seads>(mesh);
}

}  // namespace sweepkit::render
