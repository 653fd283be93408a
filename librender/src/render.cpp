// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/render/render.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "band.hpp"
#include "environment.hpp"
#include "eye_rays.hpp"
#include "intersection_tree.hpp"
#include "layers.hpp"
#include "parallel.hpp"
#include "picture_refiner.hpp"
#include "pixel_sampler.hpp"
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
  const auto hold = [&](const texmap::ImageTexture& image) {
    held += image.file ? texmap::bytes_held(*image.file) : image.image ? image.image->bytes() : 0;
  };
  for (const texmap::Texture& texture : scene.textures) {
    if (const auto* image = std::get_if<texmap::ImageTexture>(&texture)) hold(*image);
  }
  if (scene.environment) hold(*scene.environment);
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

void fill_ledger(scene::Ledger& ledger, const BandCounts& counts, const Tracer& tracer,
                 bool has_dimmed_shadows) {
  using scene::Part;
  ledger[Part::kTexcoords] = {counts.texcoord_bytes, counts.rays.texcoords};
  ledger[Part::kFilteredNodes] = {0, counts.shading.lookups.filtered};
  ledger[Part::kDifferentials] = {0, counts.shading.lookups.differentials};
  ledger[Part::kRows] = {counts.row_bytes, counts.row_bytes > 0 ? 2u : 0u};
  ledger[Part::kTrees] = {counts.reflection_bytes, counts.rays.reflected + counts.rays.refracted};
  ledger[Part::kRefractions] = {counts.refraction_bytes, counts.rays.refracted};
  ledger[Part::kShares] = {counts.share_bytes, counts.rays.shares};
  ledger[Part::kNormalMaps] = {counts.normal_bytes, counts.rays.normals};
  ledger[Part::kShadows] = {counts.visibility_bytes, counts.rays.shadow};
  ledger[Part::kDimmedShadows] = {0, has_dimmed_shadows ? counts.rays.shadow : 0};
  ledger[Part::kShadowEdges] = {0, counts.shading.smoothed};
  ledger[Part::kEnvironment] = {0, counts.shading.environment_lookups};
  ledger[Part::kRefinement] = {counts.refinement.bytes, counts.refinement.pixels};
  ledger[Part::kSupersampling] = {counts.shrink_bytes, counts.shrink_bytes > 0 ? 1u : 0u};
  if (tracer.has_object_tree()) ledger[Part::kObjectTree] = {tracer.object_tree().bytes(), 1};
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
  if (const auto& goal = options.goal) {
    if (!options.estimates_error) throw InputError("a goal needs estimates_error");
    if (options.supersampling != 1 || options.adaptive)
      throw InputError("a goal chooses the antialiasing itself; leave out supersampling and adaptive");
    if (!(goal->error >= 0) || (goal->error > 0) == static_cast<bool>(goal->seconds_left))
      throw InputError("a goal needs an error over 0 or seconds_left, one of the two");
  }
  for (std::size_t i = 0; i < options.layers.size(); ++i) {
    if (std::find(options.layers.begin(), options.layers.begin() + static_cast<std::ptrdiff_t>(i),
                  options.layers[i]) != options.layers.begin() + static_cast<std::ptrdiff_t>(i)) {
      throw InputError("the layer " + std::string(kind_of(options.layers[i]).name) +
                       " is asked for twice; once is enough");
    }
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

// The coarse picture's pixels that a part of the fine one lies in.
Region coarsened(const Region& fine, int step) {
  const int x = fine.x / step;
  const int y = fine.y / step;
  return {x, y, (fine.x + fine.width + step - 1) / step - x, (fine.y + fine.height + step - 1) / step - y};
}

texmap::Image expanded(const texmap::Image& coarse, const Region& region, const Region& fine, int step) {
  texmap::Image image = texmap::make_float_image(fine.width, fine.height, coarse.channels);
  const auto& from = std::get<std::vector<float>>(coarse.texels);
  auto to = std::get<std::vector<float>>(image.texels).begin();
  const auto channels = static_cast<std::size_t>(coarse.channels);
  for (int y = 0; y < fine.height; ++y) {
    const auto row = static_cast<std::size_t>((fine.y + y) / step - region.y);
    for (int x = 0; x < fine.width; ++x) {
      const auto column = static_cast<std::size_t>((fine.x + x) / step - region.x);
      const std::size_t at = channels * (row * static_cast<std::size_t>(coarse.width) + column);
      to = std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(at), channels, to);
    }
  }
  return image;
}

// All rows of the image, band by band on all threads.
BandCounts paint_bands(const BandPainter& painter, texmap::Image& image, const Options& options) {
  const int bands = (image.height + kBandRows - 1) / kBandRows;
  std::vector<BandCounts> counts(static_cast<std::size_t>(bands));
  std::mutex progress;
  int done = 0;

  parallel_ranges(options.threads, counts.size(), 1, [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const int band = static_cast<int>(i);
      counts[i] = painter.paint(image, band * kBandRows, std::min(image.height, (band + 1) * kBandRows),
                                options.is_cancelled);
      const std::lock_guard lock(progress);
      ++done;
      if (options.on_progress) options.on_progress(static_cast<double>(done) / bands);
    }
  });
  if (options.is_cancelled != nullptr && *options.is_cancelled) throw Cancelled{};
  BandCounts total;
  for (const BandCounts& band : counts) total.add(band);
  return total;
}

// Checks the error, refines where there is a goal, and counts both.
void estimate_error(const PixelSampler& sampler, std::vector<PixelError> errors, const Options& options,
                    Picture& picture, BandCounts& total) {
  PictureRefiner refiner(sampler, picture.image, std::move(errors));
  refiner.check();
  if (options.goal) {
    refiner.reach(*options.goal);
    total.rays.add(refiner.counts().rays);
    total.shading.add(refiner.counts().shading);
    total.refinement.pixels += refiner.refined_pixels();
    total.refinement.rays += refiner.refining_rays();
    const auto rays = std::ranges::find(picture.layers, Layer::kRays, &PictureLayer::layer);
    if (rays != picture.layers.end()) {
      std::ranges::transform(
          refiner.errors(), std::get<std::vector<float>>(rays->image.texels).begin(),
          [](const PixelError& error) { return static_cast<float>(error.rays > 1 ? 1 + error.rays : 1); });
    }
  }
  picture.error = refiner.estimate();
  picture.ledger[scene::Part::kErrorEstimate] = {refiner.bytes(), refiner.estimate().checked_pixels};
}

// Adaptive antialiasing is by a box of one pixel, and so are its textures.
Filter texture_filter(const Options& options) {
  return (options.adaptive || options.goal) && options.filter == Filter::kAuto ? Filter::kBox
                                                                               : options.filter;
}

}  // namespace

struct Renderer::Parts {
  Parts(const scene::Scene& drawn, const scene::Plan& planned, Options wanted)
      : scene(drawn),
        plan(planned),
        options(std::move(wanted)),
        start(Clock::now()),
        tracer(drawn, planned.needs_part(scene::Part::kObjectTree), options.accelerator),
        build_seconds(seconds_since(start)),
        tiles(memory_for_tiles(drawn, planned)),
        samplers(make_samplers(drawn, planned, texture_filter(options), tiles)),
        maps(drawn, tracer, samplers),
        environment(drawn, planned, options.filter, tiles) {}

  const scene::Scene& scene;
  const scene::Plan plan;
  const Options options;
  Clock::time_point start;
  Tracer tracer;
  double build_seconds;
  mutable texmap::TileCache tiles;
  Samplers samplers;
  NormalMaps maps;
  Environment environment;
};

Renderer::Renderer(const scene::Scene& scene, const scene::Plan& plan, Options options) {
  check(scene, options);
  parts_ = std::make_unique<Parts>(scene, plan, std::move(options));
}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Picture Renderer::draw(int step) const {
  const auto& [scene, plan, options, built, tracer, build_seconds, tiles, samplers, maps, environment] =
      *parts_;
  if (step < 1) throw InputError("a preview needs a step of 1 pixel or more, got " + std::to_string(step));
  Picture picture;
  Statistics& statistics = picture.statistics;
  statistics.build_seconds = build_seconds;
  count_accelerators(tracer, statistics);
  const std::uint64_t tiles_before = tiles.counts().made;

  const Clock::time_point start = Clock::now();
  const Region wanted = options.crop.value_or(Region{0, 0, scene.width, scene.height});
  const Region region = coarsened(wanted, step);
  const int supersampling = step > 1 ? 1 : options.supersampling;
  picture.image = texmap::make_float_image(region.width, region.height, options.has_alpha ? 4 : 3);
  for (const Layer layer : options.layers) {
    const auto channels = static_cast<int>(kind_of(layer).channels.size());
    picture.layers.push_back({layer, texmap::make_float_image(region.width, region.height, channels)});
  }
  const double width = static_cast<double>(scene.width) / step;
  const double height = static_cast<double>(scene.height) / step;
  const EyeRays eye_rays(scene.camera, width * supersampling, height * supersampling);
  const EyeRays middle_rays(scene.camera, width, height);
  const TreeBuilder builder(scene, plan, tracer, plan.needs_part(scene::Part::kNormalMaps) ? &maps : nullptr);
  const TextureLookup textures(scene, plan, tracer, samplers, texture_filter(options), options.footprint);
  const Shader shader(scene, plan, tracer, textures, environment, options.has_alpha);
  const LayerPainter layers(scene, tracer, builder, middle_rays, picture.layers);
  const bool estimates = step == 1 && plan.needs_part(scene::Part::kErrorEstimate);
  std::vector<PixelError> errors(
      estimates ? static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height) : 0);
  const BandPainter painter(scene, plan, eye_rays, builder, shader, layers, tiles, region, supersampling,
                            step > 1 ? std::nullopt : options.adaptive,
                            supersampling > 1 ? std::span<PixelError>() : errors);
  BandCounts total = paint_bands(painter, picture.image, options);
  if (estimates) {
    const PixelSampler sampler(builder, shader, middle_rays, tiles, region, options);
    estimate_error(sampler, std::move(errors), options, picture, total);
  }
  if (step > 1) {
    picture.image = expanded(picture.image, region, wanted, step);
    for (PictureLayer& layer : picture.layers) layer.image = expanded(layer.image, region, wanted, step);
  }
  statistics.picture_seconds = seconds_since(start) - (picture.error ? picture.error->seconds : 0);

  statistics.eye_rays = total.rays.eye;
  statistics.reflected_rays = total.rays.reflected;
  statistics.refined_pixels = total.refinement.pixels;
  statistics.refining_rays = total.refinement.rays;
  statistics.refracted_rays = total.rays.refracted;
  statistics.shadow_rays = total.rays.shadow;
  statistics.layer_rays = total.layer_rays;
  statistics.nodes = total.shading.nodes;
  statistics.filtered_nodes = total.shading.lookups.filtered;
  statistics.differential_nodes = total.shading.lookups.differentials;
  statistics.textured_nodes = total.shading.lookups.textured;
  statistics.shade_thread_seconds = total.shade_seconds;
  fill_ledger(picture.ledger, total, tracer, scene.has_dimmed_shadows);
  // Neighbours may be compared for the estimate alone.
  if (estimates && !plan.needs_part(scene::Part::kRefinement)) {
    picture.ledger[scene::Part::kErrorEstimate].bytes +=
        std::exchange(picture.ledger[scene::Part::kRefinement].bytes, 0);
  }
  for (const PictureLayer& layer : picture.layers) {
    picture.ledger[scene::Part::kLayers].bytes += layer.image.bytes();
    picture.ledger[scene::Part::kLayers].calls += 1;
  }
  std::size_t sums = 0;
  for (const auto& sampler : samplers) sums += sampler ? sampler->table_bytes() : 0;
  // The background's tiles lie among the textures'.
  const scene::Part tile_part = plan.needs_part(scene::Part::kTables)  ? scene::Part::kTables
                                : plan.needs_part(scene::Part::kTiles) ? scene::Part::kTiles
                                                                       : scene::Part::kEnvironment;
  picture.ledger[tile_part].bytes += tiles.counts().peak_bytes + sums;
  picture.ledger[tile_part].calls += tiles.counts().made - tiles_before;
  picture.ledger[scene::Part::kEnvironment].bytes += environment.table_bytes();
  return picture;
}

Picture render(const scene::Scene& scene, const scene::Plan& plan, const Options& options) {
  return Renderer(scene, plan, options).draw();
}

}  // namespace sweepkit::render
