// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "accelerators_experiment.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>

#include "mesh_accelerator.hpp"
#include "timing.hpp"
#include "traced_mesh.hpp"

namespace sweepkit::report {
namespace {

using Clock = std::chrono::steady_clock;
using render::Accelerator;
using render::Hit;
using render::Ray;

constexpr int kRounds = 5;
constexpr double kMostForLinear = 1e4;
// A scan of all triangles takes every so many-th block of rays, and its time counts as often.
constexpr std::size_t kLinearShare = 16;
constexpr std::size_t kBlock = 16;  // rays that are traced together

struct Contender {
  Accelerator kind;
  std::string name;
  std::size_t share = 1;  // of the blocks of rays, one in so many
  std::vector<double> build_seconds;
  std::vector<double> eye_seconds;
  std::vector<double> incoherent_seconds;
  double bytes = 0;
  double other_hits = 0;
};

struct Rays {
  std::vector<Ray> eye;
  std::vector<Ray> incoherent;
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Of one origin, so that blocks go together.
double trace_eye_rays(const render::MeshAccelerator& accelerator, std::span<const Ray> rays,
                      std::size_t share, std::span<Hit> hits) {
  const Clock::time_point start = Clock::now();
  for (std::size_t i = 0; i < rays.size(); i += kBlock * share) {
    const std::span<Hit> best = hits.subspan(i, kBlock);
    std::fill(best.begin(), best.end(), Hit());
    accelerator.find_nearest(rays.subspan(i, kBlock), 0, best);
  }
  return seconds_since(start) * static_cast<double>(share);
}

double trace_one_by_one(const render::MeshAccelerator& accelerator, std::span<const Ray> rays,
                        std::size_t share, std::span<Hit> hits) {
  const Clock::time_point start = Clock::now();
  for (std::size_t i = 0; i < rays.size(); i += share) {
    hits[i] = Hit();
    accelerator.find_nearest(rays[i], 0, hits[i]);
  }
  return seconds_since(start) * static_cast<double>(share);
}

// What the first accelerator, one of ours, does not find of the rays that this one has traced.
double count_other_hits(std::span<const Hit> hits, std::span<const Hit> right, std::size_t share) {
  double other = 0;
  for (std::size_t i = 0; i < hits.size(); i += kBlock * share) {
    for (std::size_t k = i; k < i + kBlock; ++k) other += hits[k].triangle == right[k].triangle ? 0 : 1;
  }
  return other * static_cast<double>(share);
}

std::vector<Contender> contenders_for(double triangles) {
  std::vector<Contender> all = {{Accelerator::kSweep, "sweep"}, {Accelerator::kSeads, "seads"}};
  if (render::has_embree()) all.push_back({Accelerator::kEmbree, "embree"});
  if (triangles <= kMostForLinear) all.push_back({Accelerator::kLinear, "linear", kLinearShare});
  return all;
}

void measure_mesh(double triangles, int side, Table& table) {
  const TracedMesh mesh = trefoil_of(triangles);
  const scene::MeshView view = mesh.view();
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const glm::vec3& position : mesh.positions) {
    low = glm::min(low, glm::dvec3(position));
    high = glm::max(high, glm::dvec3(position));
  }
  const Rays rays{eye_rays_about(low, high, side), incoherent_rays_about(low, high, side)};
  std::vector<Hit> right(rays.eye.size());
  std::vector<Hit> hits(rays.eye.size());
  std::vector<Contender> all = contenders_for(triangles);
  for (int round = 0; round < kRounds; ++round) {
    for (Contender& one : all) {
      const Clock::time_point start = Clock::now();
      const std::unique_ptr<const render::MeshAccelerator> accelerator =
          render::make_accelerator(view, one.kind);
      one.build_seconds.push_back(seconds_since(start));
      one.eye_seconds.push_back(trace_eye_rays(*accelerator, rays.eye, one.share, hits));
      if (round == 0) {
        if (one.kind == Accelerator::kSweep) right = hits;
        one.other_hits = count_other_hits(hits, right, one.share);
        one.bytes = static_cast<double>(accelerator->bytes());
      }
      one.incoherent_seconds.push_back(trace_one_by_one(*accelerator, rays.incoherent, one.share, hits));
      keep(hits);
    }
  }
  const auto count = static_cast<double>(mesh.triangles.size());
  for (const Contender& one : all) {
    const auto add = [&](const std::string& work, const std::vector<double>& seconds) {
      std::vector<Cell> row{work,      one.name,      count, static_cast<double>(rays.eye.size()),
                            one.bytes, one.other_hits};
      add_timing(row, timing_of(seconds));
      table.rows.push_back(std::move(row));
    };
    std::vector<double> total = one.build_seconds;
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += one.eye_seconds[i];
    add("build and trace", total);
    add("build", one.build_seconds);
    add("trace", one.eye_seconds);
    add("trace incoherent rays", one.incoherent_seconds);
  }
}

}  // namespace

Experiment measure_accelerators(const Effort& effort) {
  const int side = effort.is_quick ? 64 : 512;
  const std::string pixels = std::to_string(side);
  Experiment experiment{
      .name = "accelerators",
      .title = "Accelerators",
      .what =
          "The time to build an accelerator and to trace " + pixels + " x " + pixels +
          " rays by it, against the number of triangles of a tube about a trefoil knot. Every one of ours "
          "finds the same hits to the bit as a scan of all triangles in double does; what differs from "
          "them is counted.",
      .how =
          "Eye rays go by blocks of 16, incoherent ones, from a sphere about the mesh to points in its "
          "box, one by one. A scan of all triangles (linear, to 10,000 triangles) traces a sixteenth of the "
          "rays "
          "and counts its time as often. Embree runs as sweepkit calls it: it culls, and each hit is decided "
          "in double. One thread, five rounds over all in turn."};
  Table& table = experiment.table;
  table.columns = {{"work", "work"},
                   {"accelerator", "accelerator"},
                   {"triangles", "triangles"},
                   {"rays", "rays"},
                   {"bytes", "memory of the accelerator (bytes)"},
                   {"other_hits", "eye rays with another hit"}};
  for (Column& column : timing_columns("all")) table.columns.push_back(std::move(column));
  std::vector<double> sizes = {1e3, 1e4, 1e5, 1e6};
  if (!effort.is_quick) sizes = {1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6, 1e7};
  double all_triangles = 0;
  for (const double size : sizes) all_triangles += size;
  double done = 0;
  for (const double size : sizes) {
    effort.tell(done / all_triangles);
    measure_mesh(size, side, table);
    done += size;
  }
  for (const std::string work : {"build and trace", "build", "trace", "trace incoherent rays"}) {
    std::string name = "accelerators_" + work;
    std::replace(name.begin(), name.end(), ' ', '_');
    experiment.plots.push_back({.name = name,
                                .title = work,
                                .x = "triangles",
                                .y = "seconds",
                                .by = "accelerator",
                                .only = "work",
                                .only_is = work});
  }
  return experiment;
}

}  // namespace sweepkit::report
