// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "mesh_accelerator.hpp"

#include "linear_scan.hpp"
#include "seads.hpp"
#include "sweep_hierarchy.hpp"

namespace sweepkit::render {

std::unique_ptr<const MeshAccelerator> make_accelerator(const scene::MeshView& mesh, Accelerator kind) {
  if (kind == Accelerator::kLinear) return std::make_unique<LinearScan>(mesh);
  if (kind == Accelerator::kSweep) return std::make_unique<SweepHierarchy>(mesh);
  return std::make_unique<Seads>(mesh);
}

}  // namespace sweepkit::render
