// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The accelerators of one mesh beside Embree 3: building, single rays, packets, and from the mesh in memory
// to the last of 512 x 512 hits. One thread. Embree: medium quality, default flags; triangles and GRID
// geometry.
//
// Usage: bench_accelerators [FILE.csv [TRIANGLES...]]

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "embree_scene.hpp"
#include "harness.hpp"
#include "linear_scan.hpp"
#include "seads.hpp"
#include "sweep_hierarchy.hpp"
#include "sweep_meshes.hpp"
#include "traced_mesh.hpp"

namespace {

using namespace sweepkit;
using render::Hit;
using render::Ray;

constexpr int kSide = 512;

struct Rays {
  std::vector<Ray> primary;  ///< by blocks of 4 x 4 pixels
  std::vector<Ray> incoherent;
};

void trace_single(const render::MeshAccelerator& accelerator, std::span<const Ray> rays,
                  std::vector<Hit>& hits) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = Hit();
    accelerator.find_nearest(rays[i], 0, hits[i]);
  }
}

void trace_packets(const render::MeshAccelerator& accelerator, std::span<const Ray> rays,
                   std::vector<Hit>& hits) {
  for (std::size_t i = 0; i < rays.size(); i += 16) {
    const std::span<Hit> best = std::span(hits).subspan(i, 16);
    std::fill(best.begin(), best.end(), Hit());
    accelerator.find_nearest(rays.subspan(i, 16), 0, best);
  }
}

std::uint64_t hash_of(const std::vector<Hit>& hits) {
  std::uint64_t hash = 0;
  for (const Hit& hit : hits) hash = 31 * hash + hit.triangle;
  return hash;
}

// Where Embree hits another triangle, or none: how often a scan of all triangles in double agrees with us.
void compare_hits(const scene::MeshView& mesh, const std::vector<Ray>& rays, const std::vector<Hit>& ours,
                  const std::vector<bench::EmbreeHit>& theirs) {
  const render::LinearScan linear(mesh);
  int other = 0;
  int looked_at = 0;
  int agrees = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (ours[i].triangle == theirs[i].triangle) continue;
    ++other;
    if (looked_at == 32) continue;
    ++looked_at;
    Hit exact;
    linear.find_nearest(rays[i], 0, exact);
    agrees += exact.triangle == ours[i].triangle ? 1 : 0;
  }
  std::printf("  other hits than Embree's: %d of %zu; of %d a scan in double agrees with us in %d\n", other,
              rays.size(), looked_at, agrees);
}

// About so many triangles, in cells about as wide as high.
render::test::Shape vase_of(double triangles) {
  const double turn = std::sqrt(triangles / 2 * 80 / 46);
  return render::test::vase(static_cast<int>(std::round(turn * 46 / 80)), static_cast<int>(std::round(turn)));
}

void compare_on(const scene::MeshView& mesh, const std::string& name, std::vector<bench::Comparison>& out) {
  const double count = static_cast<double>(mesh.triangles.size());
  const int rounds = count > 4e6 ? 1 : count > 5e5 ? 3 : 9;
  const int trace_rounds = count > 5e5 ? 5 : 9;
  std::unique_ptr<render::SweepHierarchy> sweep;
  std::unique_ptr<render::Seads> seads;
  bench::EmbreeScene triangles(mesh, false);
  bench::EmbreeScene grid(mesh, true);
  const auto build_sweep = [&] { sweep = std::make_unique<render::SweepHierarchy>(mesh); };
  const auto note = [&](bench::Comparison comparison) {
    std::fputs(bench::to_table(comparison).c_str(), stdout);
    std::fflush(stdout);
    out.push_back(std::move(comparison));
  };
  note(bench::compare(
      name + "_build",
      {{"embree", [&] { triangles.build(); }, {}, [&] { triangles.clear(); }},
       {"embree_grid", [&] { grid.build(); }, {}, [&] { grid.clear(); }},
       {"sweep", build_sweep, {}, [&] { sweep.reset(); }},
       {"seads", [&] { seads = std::make_unique<render::Seads>(mesh); }, {}, [&] { seads.reset(); }}},
      rounds));
  const std::vector<bench::Result>& builds = out.back().results;
  std::printf("  %.0f triangles; M triangles/s: embree %.2f, grid %.1f, sweep %.0f, seads %.1f\n", count,
              1e-6 * count / builds[0].seconds.median, 1e-6 * count / builds[1].seconds.median,
              1e-6 * count / builds[2].seconds.median, 1e-6 * count / builds[3].seconds.median);
  std::printf("  bytes a triangle: embree %.1f, grid %.1f, sweep %.2f, seads %.1f\n",
              static_cast<double>(triangles.bytes()) / count, static_cast<double>(grid.bytes()) / count,
              static_cast<double>(sweep->bytes()) / count, static_cast<double>(seads->bytes()) / count);

  const render::Box& box = sweep->tree().box;
  const Rays rays{report::eye_rays_about(box.low, box.high, kSide),
                  report::incoherent_rays_about(box.low, box.high, kSide)};
  const std::vector<std::string> sets = render::instruction_sets();
  const bool has_avx2 = std::find(sets.begin(), sets.end(), "AVX2") != sets.end();
  const render::SweepHierarchy avx2(mesh, has_avx2 ? "AVX2" : sets.back());
  std::vector<Hit> hits(rays.primary.size());
  std::vector<bench::EmbreeHit> theirs(hits.size());
  trace_single(*sweep, rays.primary, hits);
  const std::uint64_t right_primary = hash_of(hits);
  trace_single(*sweep, rays.incoherent, hits);
  const std::uint64_t right_incoherent = hash_of(hits);
  const auto is_right = [&](std::uint64_t right) {
    return [&hits, right] { return std::string(hash_of(hits) == right ? "" : "other hits"); };
  };
  for (const bool is_primary : {true, false}) {
    const std::vector<Ray>& some = is_primary ? rays.primary : rays.incoherent;
    const auto check = is_right(is_primary ? right_primary : right_incoherent);
    note(bench::compare(name + (is_primary ? "_primary" : "_incoherent"),
                        {{"embree_x1", [&] { triangles.intersect_single(some, theirs); }},
                         {"sweep", [&] { trace_single(*sweep, some, hits); }, check},
                         {"sweep_avx2", [&] { trace_single(avx2, some, hits); }, check},
                         {"seads", [&] { trace_single(*seads, some, hits); }, check}},
                        trace_rounds));
    trace_single(*sweep, some, hits);
    triangles.intersect_single(some, theirs);
    compare_hits(mesh, some, hits, theirs);
  }
  note(bench::compare(
      name + "_packets",
      {{"embree_x16", [&] { triangles.intersect_packets(rays.primary, theirs); }},
       {"embree_grid_x16", [&] { grid.intersect_packets(rays.primary, theirs); }},
       {"embree_grid_x1", [&] { grid.intersect_single(rays.primary, theirs); }},
       {"sweep_x16", [&] { trace_packets(*sweep, rays.primary, hits); }, is_right(right_primary)},
       {"sweep_avx2_x16", [&] { trace_packets(avx2, rays.primary, hits); }, is_right(right_primary)}},
      trace_rounds));
  const auto embree = [&](bench::EmbreeScene& scene, bool has_packets) {
    return [&, has_packets] {
      scene.build();
      if (has_packets) {
        scene.intersect_packets(rays.primary, theirs);
      } else {
        scene.intersect_single(rays.primary, theirs);
      }
    };
  };
  note(bench::compare(name + "_total",
                      {{"embree_x1", embree(triangles, false), {}, [&] { triangles.clear(); }},
                       {"embree_x16", embree(triangles, true), {}, [&] { triangles.clear(); }},
                       {"embree_grid_x1", embree(grid, false), {}, [&] { grid.clear(); }},
                       {"embree_grid_x16", embree(grid, true), {}, [&] { grid.clear(); }},
                       {"sweep_x1",
                        [&] {
                          build_sweep();
                          trace_single(*sweep, rays.primary, hits);
                        },
                        is_right(right_primary), [&] { sweep.reset(); }},
                       {"sweep_x16",
                        [&] {
                          build_sweep();
                          trace_packets(*sweep, rays.primary, hits);
                        },
                        is_right(right_primary), [&] { sweep.reset(); }}},
                      rounds));
}

int compare_all(int argc, char** argv) {
  std::vector<double> sizes;
  for (int i = 2; i < argc; ++i) sizes.push_back(std::strtod(argv[i], nullptr));
  if (sizes.empty()) sizes = {7200, 1e5, 1e6, 8e6};
  std::vector<bench::Comparison> comparisons;
  for (const double size : sizes) {
    char text[32];
    std::snprintf(text, sizeof text, "_%.2g", size);
    compare_on(vase_of(size).view(), std::string("vase") + text, comparisons);
    compare_on(report::trefoil_of(size).view(), std::string("trefoil") + text, comparisons);
  }
  if (argc > 1 && !(std::ofstream(argv[1]) << bench::to_csv(comparisons))) {
    std::fprintf(stderr, "%s: cannot be written\n", argv[1]);
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return compare_all(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
