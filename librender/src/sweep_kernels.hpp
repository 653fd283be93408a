// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "box_tree.hpp"
#include "ray.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::render {

/// What a search looks through.
struct TreeView {
  const scene::MeshView* mesh;
  const BoxTree* tree;
  std::uint32_t object;
};

/// The searches, compiled for one instruction set. All of them find the same to the bit. Precondition: the
/// tree's reach is below 2^60.
struct SweepKernels {
  void (*find_nearest)(const TreeView& view, const Ray& ray, Hit& best);
  void (*find_nearest_packet)(const TreeView& view, std::span<const Ray> rays, std::span<Hit> best);
  bool (*is_blocked)(const TreeView& view, const Ray& ray, double end);
};

/// The instruction sets that this machine has, by Highway's names, the best first.
std::vector<std::string> instruction_sets();

/// Precondition: `instruction_set` is one of them.
SweepKernels sweep_kernels(const std::string& instruction_set);

}  // namespace sweepkit::render
