// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "object_tree.hpp"
#include "pixel_error.hpp"
#include "pixel_sampler.hpp"
#include "sweepkit/render/render.hpp"
#include "tracer.hpp"

namespace sweepkit::render {
namespace {

// An object as rays see it; where there are several, its box and number while the tree is built, and a node.
constexpr std::uint64_t kBytesAnObject = sizeof(TracedObject) + sizeof(Box) + 4 + 56;

// Linear float RGB, and while a file is encoded the file's samples and the file.
constexpr std::uint64_t kBytesAPixel = 3 * (4 + 2 + 2);
// What the error estimate keeps of a pixel; and, where it is refined to reach a goal, its sums.
constexpr std::uint64_t kBytesAnEstimate = sizeof(PixelError) + 4;
constexpr std::uint64_t kBytesAGoal = 4 + sizeof(ColorSums);

}  // namespace

// Triangles that are counted before they are made are those of sweeps, which kAuto searches by kSweep. A grid
// of 8 voxels a triangle: 4 bytes a voxel, and the triangle stands in about 3 of them, twice, with its count.
// Embree: measured.
std::uint64_t bytes_a_triangle(Accelerator accelerator) {
  switch (accelerator) {
    case Accelerator::kLinear:
      return 0;
    case Accelerator::kSeads:
      return 8 * 4 + 3 * 2 * 4 + 4;
    case Accelerator::kEmbree:
      return 90;
    case Accelerator::kSweep:
    case Accelerator::kAuto:
      return 4;
  }
  return 0;
}

std::uint64_t estimate_memory(const scene::MemoryEstimate& scene, int width, int height,
                              const Options& options) {
  const Region region = options.crop.value_or(Region{0, 0, width, height});
  const std::uint64_t bytes_a_pixel =
      kBytesAPixel + (options.estimates_error ? kBytesAnEstimate : 0) + (options.goal ? kBytesAGoal : 0);
  return scene.triangles * bytes_a_triangle(options.accelerator) + scene.objects * kBytesAnObject +
         static_cast<std::uint64_t>(region.width) * static_cast<std::uint64_t>(region.height) * bytes_a_pixel;
}

}  // namespace sweepkit::render
