// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "mesh_accelerator.hpp"

namespace sweepkit::render {

/// Every triangle, one after another: the reference that the others are held against.
class LinearScan final : public MeshAccelerator {
 public:
  explicit LinearScan(const scene::MeshView& mesh) : mesh_(mesh) {}

  using MeshAccelerator::find_nearest;
  void find_nearest(const Ray& ray, std::uint32_t object, Hit& best) const override;
  bool is_blocked(const Ray& ray, std::uint32_t object, double end) const override;
  std::size_t bytes() const override { return 0; }

 private:
  const scene::MeshView& mesh_;
};

}  // namespace sweepkit::render
