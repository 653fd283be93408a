// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/render/render.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "band.hpp"
#include "intersection_tree.hpp"
#include "shading.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_file.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"
#include "sweepkit/texmap/tile_cache.hpp"
#include "tracer.hpp"

namespace sweepkit::render {
namespace {

using Clock = std::chrono::steady_clock;

// Rows of a band. Each band traces two rows more than it draws, so a short one wastes work and a long one
// leaves threads idle at the end: at 32 the waste is 6 %.
constexpr int kBandRows = 32;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Samplers make_samplers(const scene::Scene& scene, const scene::Plan& plan, texmap::Filter filter,
                       texmap::TileCache& tiles) {
  Samplers samplers(scene.textures.size());
  for (std::size_t i = 0; i < samplers.size(); ++i) {
    if (!plan.sampled[i]) continue;
    samplers[i].emplace(std::get<texmap::ImageTexture>(scene.textures[i]), filter, tiles,
                        static_cast<std::uint32_t>(i));
  }
  return samplers;
}

// What the images themselves leave of the textures' memory, and a quarter of it at least: without tiles to
// read from nothing could be drawn.
std::size_t memory_for_tiles(const scene::Scene& scene, const scene::Plan& plan) {
  std::size_t held = 0;
  for (const texmap::Texture& texture : scene.textures) {
    if (const auto* image = std::get_if<texmap::ImageTexture>(&texture))
      held += image->file ? texmap::bytes_held(*image->file) : image->image ? image->image->bytes() : 0;
  }
  const std::size_t all = plan.texture_memory;
  return std::max(all / 4, all - std::min(all, held));
}

void count_accelerators(const Tracer& tracer, Statistics& statistics) {
  std::vector<std::uint32_t> counts;
  for (const auto& accelerator : tracer.accelerators()) {
    if (!accelerator) continue;
    statistics.accelerator_bytes += accelerator->bytes();
    statistics.voxels += accelerator->count_occupancy(counts);
  }
  if (counts.empty()) return;
  const auto at = [&](double share) {
    const auto position =
        counts.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(counts.size() - 1));
    std::nth_element(counts.begin(), position, counts.end());
    return *position;
  };
  statistics.median_triangles = at(0.5);
  statistics.p99_triangles = at(0.99);
  statistics.max_triangles = at(1.0);
}

void fill_ledger(scene::Ledger& ledger, const BandCounts& counts, const Tracer& tracer) {
  using scene::Part;
  ledger[Part::kTexcoords] = {counts.texcoord_bytes, counts.rays.texcoords};
  ledger[Part::kFilteredNodes] = {0, counts.shading.lookups.filtered};
  ledger[Part::kDifferentials] = {0, counts.shading.lookups.differentials};
  ledger[Part::kRows] = {counts.row_bytes, counts.row_bytes > 0 ? 2u : 0u};
  ledger[Part::kTrees] = {counts.link_bytes, counts.rays.reflected};
  ledger[Part::kShadows] = {counts.visibility_bytes, counts.rays.shadow};
  ledger[Part::kShadowEdges] = {0, counts.shading.smoothed};
  ledger[Part::kRefinement] = {counts.refinement.bytes, counts.refinement.pixels};
  ledger[Part::kSupersampling] = {counts.shrink_bytes, counts.shrink_bytes > 0 ? 1u : 0u};
  if (tracer.has_global_grid()) ledger[Part::kGlobalGrid] = {tracer.global_grid().bytes(), 1};
}

void check(const scene::Scene& scene, const Options& options) {
  if (options.supersampling < 1 || options.supersampling > 64) {
    throw InputError("supersampling needs 1 to 64 samples a side, got " +
                     std::to_string(options.supersampling));
  }
  if (options.threads < 0 || options.threads > 4096) {
    throw InputError("threads needs 0 (all) to 4096, got " + std::to_string(options.threads));
  }
  if (const auto& adaptive = options.adaptive) {
    if (options.supersampling != 1) {
      throw InputError("adaptive antialiasing needs a supersampling of 1, got " +
                       std::to_string(options.supersampling));
    }
    if (!(adaptive->contrast > 0))
      throw InputError("contrast needs a number over 0, got " + std::to_string(adaptive->contrast));
    if (adaptive->most_rays < kFewestRefiningRays || adaptive->most_rays > kMostRefiningRays)
      throw InputError("most_rays needs 4 to 256, got " + std::to_string(adaptive->most_rays));
  }
  if (const auto& crop = options.crop) {
    const bool is_inside = crop->x >= 0 && crop->y >= 0 && crop->width > 0 && crop->height > 0 &&
                           crop->x <= scene.width - crop->width && crop->y <= scene.height - crop->height;
    if (!is_inside) {
      throw InputError("crop needs pixels inside the picture of " + std::to_string(scene.width) + " x " +
                       std::to_string(scene.height) + ", got " + std::to_string(crop->width) + " x " +
                       std::to_string(crop->height) + " at " + std::to_string(crop->x) + ", " +
                       std::to_string(crop->y));
    }
  }
}

}  // namespace

Picture render(const scene::Scene& scene, const scene::Plan& plan, const Options& options) {
  check(scene, options);
  Picture picture;
  Statistics& statistics = picture.statistics;

  Clock::time_point start = Clock::now();
  const Tracer tracer(scene, plan.needs_part(scene::Part::kGlobalGrid), options.accelerator);
  statistics.build_seconds = seconds_since(start);
  count_accelerators(tracer, statistics);

  // Adaptive antialiasing is by a box of one pixel, and so are its textures.
  const Filter filter = options.adaptive && options.filter == Filter::kAuto ? Filter::kBox : options.filter;
  texmap::TileCache tiles(memory_for_tiles(scene, plan));
  const Samplers samplers = make_samplers(scene, plan, filter, tiles);

  start = Clock::now();
  const Region region = options.crop.value_or(Region{0, 0, scene.width, scene.height});
  picture.image = texmap::make_float_image(region.width, region.height);
  if (options.counts_rays) {
    const auto each = static_cast<std::uint16_t>(options.supersampling * options.supersampling);
    picture.eye_rays.assign(static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height),
                            each);
  }
  const TreeBuilder builder(scene, plan, tracer);
  const TextureLookup textures(scene, plan, tracer, samplers, filter, options.footprint);
  const Shader shader(scene, plan, textures);
  const BandPainter painter(scene, plan, builder, shader, tiles, region, options);
  const int bands = (region.height + kBandRows - 1) / kBandRows;
  std::vector<BandCounts> counts(static_cast<std::size_t>(bands));
  std::mutex progress;
  int done = 0;

  // More threads than the machine has must be allowed first, or TBB prints a warning and takes fewer.
  std::optional<tbb::global_control> allowed;
  if (options.threads > 0) {
    allowed.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  }
  tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, bands, 1), [&](const tbb::blocked_range<int>& range) {
      for (int band = range.begin(); band < range.end(); ++band) {
        counts[static_cast<std::size_t>(band)] =
            painter.paint(picture.image, picture.eye_rays, band * kBandRows,
                          std::min(region.height, (band + 1) * kBandRows), options.is_cancelled);
        const std::lock_guard lock(progress);
        ++done;
        if (options.on_progress) options.on_progress(static_cast<double>(done) / bands);
      }
    });
  });
  if (options.is_cancelled != nullptr && *options.is_cancelled) throw Cancelled{};
  statistics.picture_seconds = seconds_since(start);

  BandCounts total;
  for (const BandCounts& band : counts) total.add(band);
  statistics.eye_rays = total.rays.eye;
  statistics.reflected_rays = total.rays.reflected;
  statistics.refined_pixels = total.refinement.pixels;
  statistics.refining_rays = total.refinement.rays;
  statistics.shadow_rays = total.rays.shadow;
  statistics.nodes = total.shading.nodes;
  statistics.filtered_nodes = total.shading.lookups.filtered;
  statistics.differential_nodes = total.shading.lookups.differentials;
  statistics.textured_nodes = total.shading.lookups.textured;
  statistics.shade_thread_seconds = total.shade_seconds;
  fill_ledger(picture.ledger, total, tracer);
  std::size_t sums = 0;
  for (const auto& sampler : samplers) sums += sampler ? sampler->table_bytes() : 0;
  picture.ledger[texmap::reads_table(filter) ? scene::Part::kTables : scene::Part::kTiles] = {
      tiles.counts().peak_bytes + sums, tiles.counts().made};
  return picture;
}

}  // namespace sweepkit::render
