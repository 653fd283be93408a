// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sweepkit/render/layer.hpp"
#include "sweepkit/render/picture_error.hpp"
#include "sweepkit/scene/memory_estimate.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/image.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"

namespace sweepkit::render {

using texmap::Filter;

enum class Footprint {
  kNeighbours,     ///< as the paper has it: only where all eight neighbours lie on the same piece of texture;
                   ///< tables of integrals take the box about them as it is, two pixels wide
  kDifferentials,  ///< steps of one pixel by the eye ray's derivatives, carried along its path [Igehy99]
  kAuto,  ///< steps of one pixel by differences to the four next neighbours, or those that are there; where
          ///< a direction has none (silhouettes, thin things), by derivatives
};

/// How much of a light comes to a point.
enum class Shadows {
  kHard,    ///< all or nothing, by one shadow ray for a light without a radius
  kSmooth,  ///< the same rays, averaged over the neighbouring pixels' on the same piece of surface
};

inline constexpr int kFewestRefiningRays = 4;
inline constexpr int kMostRefiningRays = 256;

/// More eye rays for the pixels that differ from a neighbour beside, above or below: in object, path, piece
/// of surface, normal (26 degrees) or in what they see of a light, or by more than `contrast` in colour. Such
/// a pixel is drawn by 4 rays, then by twice as many again and again, until another ray would lower its
/// squared error by less than about (contrast / 12)^2. Its filter is a box of one pixel, and so is that of
/// textures with Filter::kAuto, which then stands for kBox; those need no more rays and their contrast does
/// not count.
///
/// What one ray a pixel misses altogether, a wire thinner than a pixel, is found only where it is hit.
struct Adaptive {
  double contrast = 0.03;  ///< in R, G or B, linear light; over 0
  int most_rays = 64;      ///< in a pixel, besides its first; 4 to 256, counted down to a power of two
};

/// How the triangles that a ray meets are found.
enum class Accelerator {
  kSeads,   ///< the paper's grids (3.3)
  kSweep,   ///< ours: boxes over blocks of the (u,v) grid, without a search
  kLinear,  ///< every triangle: the reference that tests compare the others with
  kEmbree,  ///< Intel's, where this build has it: float32 culls, so a few pixels may differ
  kAuto,    ///< the fastest of ours for each mesh
};
inline constexpr std::array<std::string_view, 5> kAcceleratorNames = {"seads", "sweep", "linear", "embree",
                                                                      "auto"};
/// Is kEmbree in this build?
bool has_embree();

/// Pixels x..x+width-1, y..y+height-1, y down from the top.
struct Region {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// One eye ray a pixel, and more where they are asked for; or a picture n times as large each way, shrunk. 3
/// takes the paper's weights (1/4 in the middle, 1/8 at the sides, 1/16 at the corners), any other n equal
/// ones: 16 makes a reference under a box of one pixel.
struct Options {
  Filter filter = Filter::kAuto;
  Footprint footprint = Footprint::kAuto;
  int supersampling = 1;             ///< 1 to 64
  std::optional<Adaptive> adaptive;  ///< only with a supersampling of 1
  bool estimates_error = false;      ///< Picture::error
  std::optional<Goal> goal;          ///< with estimates_error, and without the two above; filters as adaptive
  Shadows shadows = Shadows::kSmooth;
  std::optional<Region> crop;  ///< this part of the picture alone, the same bytes; inside it, not empty
  bool has_alpha = false;      ///< leave the background out and say what objects cover
  std::vector<Layer> layers;   ///< none twice
  int threads = 0;             ///< 0: as many as the machine has
  Accelerator accelerator = Accelerator::kAuto;  ///< the picture is the same with any of ours
  std::function<void(double done)>
      on_progress;  ///< share of the picture, 0 to 1; called from any thread, one at a time
  const std::atomic<bool>* is_cancelled =
      nullptr;  ///< looked at between rows; render() then throws Cancelled
};

struct Cancelled {};

struct Statistics {
  std::uint64_t eye_rays = 0;
  std::uint64_t refined_pixels = 0;  ///< with more than one eye ray, by Options::adaptive or goal
  std::uint64_t refining_rays = 0;   ///< of the eye rays, those more
  std::uint64_t reflected_rays = 0;
  std::uint64_t refracted_rays = 0;
  std::uint64_t shadow_rays = 0;
  std::uint64_t layer_rays = 0;          ///< through pixels' middles, for the layers alone
  std::uint64_t nodes = 0;               ///< intersection-tree nodes shaded
  std::uint64_t filtered_nodes = 0;      ///< of them, filtered over their neighbours
  std::uint64_t differential_nodes = 0;  ///< of them, filtered by ray differentials
  std::uint64_t textured_nodes = 0;
  double build_seconds = 0;         ///< building the accelerators
  double picture_seconds = 0;       ///< tracing and shading, wall clock
  double shade_thread_seconds = 0;  ///< of them shading, summed over threads
  std::uint64_t accelerator_bytes = 0;
  std::uint64_t voxels = 0;
  std::uint32_t median_triangles = 0;  ///< in the voxels that hold any
  std::uint32_t p99_triangles = 0;
  std::uint32_t max_triangles = 0;
};

struct Picture {
  /// Float RGB, linear light; of the crop where there is one. With alpha RGBA, the colours multiplied by it:
  /// the share of the pixel's rays that met an object (glass is an object).
  texmap::Image image;
  std::vector<PictureLayer> layers;  ///< as asked for, as large as the image
  Statistics statistics;
  scene::Ledger ledger;
  std::optional<ErrorEstimate> error;  ///< where it was asked for; not of a preview
};

/// What an accelerator takes at most for a triangle while it is built.
std::uint64_t bytes_a_triangle(Accelerator accelerator);

/// About what render() and writing its picture of so many pixels take besides the scene itself and its
/// textures, bytes.
std::uint64_t estimate_memory(const scene::MemoryEstimate& scene, int width, int height,
                              const Options& options = {});

/// A scene made ready to be drawn again and again: its accelerators are built, tiles and tables of its
/// textures are kept from one picture to the next.
class Renderer {
 public:
  /// `scene` must outlive this and keep its meshes, objects, materials and textures; its camera, lights and
  /// background may change between two pictures. `plan` and `options` are as render() has them; what
  /// `options` points at must live as long. Throws InputError for options that cannot be.
  Renderer(const scene::Scene& scene, const scene::Plan& plan, Options options);
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// The picture. With `step` n > 1 a rough one as large, of n x n pixels in one colour, by one eye ray each
  /// through their common middle: for a preview, in 1/n^2 of the time.
  Picture draw(int step = 1) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Draws the scene once: rows of intersection trees, three at a time, each node's texture filtered over the
/// neighbouring pixels' hits [Akdemir98, section 3]. The same scene gives the same bytes for any number of
/// threads. `plan` says what may be left out; it must come from the same document and a request that fits
/// `options`. Throws InputError for options out of range, and Cancelled.
Picture render(const scene::Scene& scene, const scene::Plan& plan, const Options& options = {});

}  // namespace sweepkit::render
