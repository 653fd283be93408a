// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "pixel_sampler.hpp"

#include <mutex>

#include "parallel.hpp"

namespace sweepkit::render {
namespace {

// Pixels of a thread's turn: its tiles and rows are made ready anew for each.
constexpr std::size_t kGrain = 32;
// Light is no linear function of the normal, so the light of a mean normal is not the mean light: normal maps
// are averaged over less than the ray's share of the pixel, and its many rays do the rest.
constexpr double kSideOfNormals = 0.25;

}  // namespace

void PixelSampler::Thread::add(ColorSums& sums, std::size_t pixel, std::span<const glm::dvec2> places,
                               double side) {
  const auto width = static_cast<std::size_t>(sampler_.region_.width);
  const glm::dvec2 corner(sampler_.region_.x + static_cast<int>(pixel % width),
                          sampler_.region_.y + static_cast<int>(pixel / width));
  row_.places.clear();
  for (const glm::dvec2& place : places) row_.places.push_back(corner + place);
  sampler_.builder_.build(row_, sampler_.eye_rays_, rays, &filter_, kSideOfNormals * side);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec4 color =
        sampler_.shader_.sample(row_, sampler_.eye_rays_, i, side, filter_, shading).color;
    sums.sum += color;
    sums.squares += color * color;
  }
}

void PixelSampler::for_each(std::size_t count, const std::function<void(Thread&, std::size_t)>& work,
                            Counts& counts) const {
  const auto is_cancelled = [&] { return options_.is_cancelled != nullptr && *options_.is_cancelled; };
  std::mutex adding;
  parallel_ranges(options_.threads, count, kGrain, [&](const tbb::blocked_range<std::size_t>& range) {
    if (is_cancelled()) return;
    Thread thread(*this);
    for (std::size_t i = range.begin(); i < range.end(); ++i) work(thread, i);
    const std::lock_guard lock(adding);
    counts.rays.add(thread.rays);
    counts.shading.add(thread.shading);
  });
  if (is_cancelled()) throw Cancelled{};
}

}  // namespace sweepkit::render
