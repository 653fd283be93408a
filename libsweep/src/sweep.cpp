// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The way of a sweep: outlines are divided into columns (outline_sampler, morph), the trajectory's corners
// are joined (joints) and it is divided into rows (stations, orientation, rows), every outline sweeps a wall
// (wall), and the ends are capped (flat_cap, round_cap).

#include "sweepkit/sweep/sweep.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "flat_cap.hpp"
#include "grid_writer.hpp"
#include "half_edges.hpp"
#include "joints.hpp"
#include "number_text.hpp"
#include "orientation.hpp"
#include "outline_sampler.hpp"
#include "round_cap.hpp"
#include "rows.hpp"
#include "section.hpp"
#include "sweepkit/error.hpp"
#include "wall.hpp"

namespace sweepkit::sweep {
namespace {

void check_options(std::span<const Curve2> contour, const SweepOptions& options) {
  check_cells(options.tessellation.contour, "contour");
  check_cells(options.tessellation.trajectory, "trajectory");
  check_texture(options.uv);
  if (!(options.miter_limit >= 1)) {
    throw InputError("miter_limit needs to be 1 or more, got " + number_text(options.miter_limit));
  }
  if (options.caps == Caps::kRound && contour.size() > 1) {
    throw InputError("caps that are round need a contour of one outline, got " +
                     std::to_string(contour.size()) + "; make them flat");
  }
}

std::vector<bool> row_breaks(const std::vector<Row>& rows, const SweepOptions& options) {
  // At 180 degrees nothing breaks.
  const double crease_cos = crease_cosine(options.joints == Joints::kSmooth ? 180 : options.crease_deg);
  std::vector<bool> breaks;
  breaks.reserve(rows.size());
  for (const Row& row : rows) {
    breaks.push_back(row.is_pole ||
                     (row.is_corner && glm::dot(row.in.frame.tangent, row.out.frame.tangent) < crease_cos));
  }
  return breaks;
}

double reach_of(const std::vector<Morph>& morphs) {
  double reach = 0;
  for (const Morph& morph : morphs) reach = std::max(reach, reach_of(morph));
  return reach;
}

// Turned by a whole turn / this, every outline covers itself.
int symmetry_of(const std::vector<Morph>& morphs) {
  int symmetry = 0;
  for (const Morph& morph : morphs) {
    // What changes on the way is not looked into.
    symmetry = std::gcd(symmetry, morph.changes() ? 1 : symmetry_of(morph.keys.front()));
  }
  return symmetry;
}

void check_morphs_close(const std::vector<Morph>& morphs) {
  for (const Morph& morph : morphs) {
    if (!morph.changes()) continue;
    const Section last = section_at(morph, 1);
    const Section& first = morph.keys.front();
    for (std::size_t i = 0; i < first.points.size(); ++i) {
      // A millionth is what float32 would not show.
      if (glm::length(last.points[i].position - first.points[i].position) > 1e-6 * reach_of(first)) {
        throw InputError(
            "morph ends in another contour than it began with, but the trajectory is closed; end it with the "
            "contour itself at t = 1");
      }
    }
  }
}

std::size_t closing_columns(const Morph& morph, int symmetry, int closing_steps, bool is_hole) {
  const auto columns = static_cast<int>(morph.columns());
  // A hole's columns run the other way round.
  const int steps = ((is_hole ? -closing_steps : closing_steps) % symmetry + symmetry) % symmetry;
  return static_cast<std::size_t>(columns / symmetry * steps);
}

Spine make_spine(const Curve3& trajectory, const std::vector<Station>& stations,
                 const std::vector<StationFrames>& frames, const SweepOptions& options) {
  Spine spine;
  spine.rows = make_rows(trajectory, stations, frames, options.profile);
  spine.breaks = row_breaks(spine.rows, options);
  spine.poles.resize(spine.rows.size());
  std::transform(spine.rows.begin(), spine.rows.end(), spine.poles.begin(),
                 [](const Row& row) { return row.is_pole; });
  spine.shares = texture_fractions(stations, UvBy::kArcLength);
  spine.v = texture_fractions(stations, options.uv.by);
  spine.runs = split_runs(spine.breaks);
  spine.length = trajectory.length();
  spine.is_closed = trajectory.is_closed();
  return spine;
}

glm::dvec3 middle_of(const Spine& spine, double reach) {
  glm::dvec3 low = spine.rows.front().center;
  glm::dvec3 high = low;
  for (const Row& row : spine.rows) {
    const double size = reach * std::max(glm::length(row.x_axis), glm::length(row.y_axis));
    low = glm::min(low, row.center - size);
    high = glm::max(high, row.center + size);
  }
  return choose_origin(low, high);
}

// A section that the profile has shrunk to a point or pressed flat is closed without a cap.
bool needs_cap(const Row& row) {
  return glm::length(row.x_axis) > 0 && glm::length(row.y_axis) > 0;
}

void add_cap(Mesh& mesh, const std::vector<Morph>& morphs, const std::vector<std::size_t>& outer_of,
             const Spine& spine, End end, const SweepOptions& options) {
  const bool is_first = end == End::kFirst;
  const Row& row = is_first ? spine.rows.front() : spine.rows.back();
  if (!needs_cap(row)) return;
  std::vector<Section> sections;
  sections.reserve(morphs.size());
  for (const Morph& morph : morphs) sections.push_back(section_at(morph, is_first ? 0 : 1));
  if (options.caps == Caps::kRound) {
    // As many cells over the dome as over a quarter of the contour, and enough to look round.
    const auto cells =
        static_cast<std::uint32_t>(std::max<std::size_t>(4, (morphs.front().columns() + 3) / 4));
    add_round_cap(mesh, sections.front(), row, end, cells, options.uv);
    return;
  }
  // Seen from outside the first cap shows the contour mirrored.
  const glm::dvec3 outwards = is_first ? -row.out.frame.tangent : row.in.frame.tangent;
  add_flat_caps(mesh, sections, outer_of, {row.center, row.x_axis, row.y_axis, outwards}, is_first);
}

}  // namespace

Mesh sweep(std::span<const Curve2> contour, const Curve3& given_trajectory, const SweepOptions& options) {
  check_options(contour, options);
  const ContourSamplers samplers = make_samplers(contour, options.morph, options.crease_deg, options.uv.by,
                                                 OutlineSampler::PiecesBy::kCorners);
  std::vector<Morph> morphs = sample(samplers, options.tessellation.contour);
  const double reach = reach_of(morphs);
  const auto [trajectory, least_cells] =
      join_corners(given_trajectory, options.joints, options.miter_limit, [&](double length) {
        const double t = length / given_trajectory.length();
        return reach * std::max(options.profile.x.at(t).value, options.profile.y.at(t).value);
      });
  const std::vector<Station> stations =
      place_stations(trajectory, options.tessellation.trajectory, least_cells);
  if (trajectory.is_closed()) {
    check_loop(stations.size() - 1, "trajectory");
    check_morphs_close(morphs);
  }
  const int symmetry = trajectory.is_closed() ? symmetry_of(morphs) : 1;
  const Oriented oriented = orient(trajectory, stations, options.orientation, options.twist_deg, symmetry);
  const Spine spine = make_spine(trajectory, stations, oriented.frames, options);

  Mesh mesh;
  mesh.origin = middle_of(spine, reach);
  for (std::size_t i = 0; i < morphs.size(); ++i) {
    const bool is_hole = samplers.outer_of[i] != i;
    const Wall wall{morphs[i], split_runs(morphs[i].keys.front().breaks),
                    closing_columns(morphs[i], symmetry, oriented.closing_steps, is_hole)};
    add_wall(mesh, wall, spine, options.uv);
  }
  if (options.caps != Caps::kNone && contour.front().is_closed() && !trajectory.is_closed()) {
    add_cap(mesh, morphs, samplers.outer_of, spine, End::kFirst, options);
    add_cap(mesh, morphs, samplers.outer_of, spine, End::kLast, options);
  }
  if (options.has_half_edges) write_half_edges(mesh);
  return mesh;
}

Mesh sweep(const Curve2& contour, const Curve3& trajectory, const SweepOptions& options) {
  return sweep(std::span(&contour, 1), trajectory, options);
}

}  // namespace sweepkit::sweep
