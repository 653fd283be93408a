// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweep_hierarchy.hpp"

#include "build_box_tree.hpp"
#include "linear_scan.hpp"

namespace sweepkit::render {
namespace {

// Float32 boxes cannot tell apart what is this large; nothing else could either.
constexpr double kLargestReach = 0x1p60;

}  // namespace

SweepHierarchy::SweepHierarchy(const scene::MeshView& mesh)
    : SweepHierarchy(mesh, instruction_sets().front()) {}

SweepHierarchy::SweepHierarchy(const scene::MeshView& mesh, const std::string& instruction_set)
    : mesh_(mesh), kernels_(sweep_kernels(instruction_set)), tree_(build_box_tree(mesh)) {}

void SweepHierarchy::find_nearest(const Ray& ray, std::uint32_t object, Hit& best) const {
  if (!(tree_.reach < kLargestReach)) return LinearScan(mesh_).find_nearest(ray, object, best);
  kernels_.find_nearest({&mesh_, &tree_, object}, ray, best);
}

void SweepHierarchy::find_nearest(std::span<const Ray> rays, std::uint32_t object,
                                  std::span<Hit> best) const {
  if (!(tree_.reach < kLargestReach)) return LinearScan(mesh_).find_nearest(rays, object, best);
  while (!rays.empty()) {
    const std::size_t count = std::min<std::size_t>(rays.size(), kWidth);
    kernels_.find_nearest_packet({&mesh_, &tree_, object}, rays.first(count), best.first(count));
    rays = rays.subspan(count);
    best = best.subspan(count);
  }
}

bool SweepHierarchy::is_blocked(const Ray& ray, std::uint32_t object, double end) const {
  if (!(tree_.reach < kLargestReach)) return LinearScan(mesh_).is_blocked(ray, object, end);
  return kernels_.is_blocked({&mesh_, &tree_, object}, ray, end);
}

}  // namespace sweepkit::render
