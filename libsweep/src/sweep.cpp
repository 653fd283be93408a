// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The way of a sweep: outlines are divided into columns (outline_sampler, morph), the trajectory's corners
// are joined (joints) and it is divided into rows (stations, orientation, rows, spine) - by counts, or finely
// and then thinned out to a tolerance (dense_sweep, tolerance). Every outline sweeps a wall (wall), and the
// ends are capped (flat_cap, round_cap).

#include "sweepkit/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "counted_sweep.hpp"
#include "dense_sweep.hpp"
#include "flat_cap.hpp"
#include "float_positions.hpp"
#include "half_edges.hpp"
#include "joints.hpp"
#include "number_text.hpp"
#include "outline_sampler.hpp"
#include "round_cap.hpp"
#include "section.hpp"
#include "spine.hpp"
#include "sweepkit/error.hpp"
#include "texture_repeats.hpp"
#include "tolerance.hpp"
#include "wall.hpp"

namespace sweepkit::sweep {
namespace {

// Of a dense sweep, each 4 times as many rows and columns.
constexpr int kMostDensity = 3;

// Ready to be written.
struct Swept {
  std::vector<Morph> morphs;  // an outline
  std::vector<std::size_t> outer_of;
  std::vector<std::size_t> closing_columns;
  Spine spine;
  std::optional<Grid> grid;   // that a tolerance has chosen
  double dome_tolerance = 0;  // metres, of what the tolerance leaves to the rows of round caps
};

void check_options(std::span<const Curve2> contour, const SweepOptions& options) {
  check_cells(options.tessellation.contour, "contour");
  check_cells(options.tessellation.trajectory, "trajectory");
  check_tolerance(options.tessellation.tolerance);
  check_texture(options.uv);
  if (!(options.miter_limit >= 1)) {
    throw InputError("miter_limit needs to be 1 or more, got " + number_text(options.miter_limit));
  }
  if (options.caps == Caps::kRound && contour.size() > 1) {
    throw InputError("caps that are round need a contour of one outline, got " +
                     std::to_string(contour.size()) + "; make them flat");
  }
}

// About everything swept.
Box box_of(const Spine& spine, double reach) {
  Box box{spine.rows.front().center, spine.rows.front().center};
  for (const Row& row : spine.rows) {
    const double size = reach * std::max(glm::length(row.x_axis), glm::length(row.y_axis));
    box.low = glm::min(box.low, row.center - size);
    box.high = glm::max(box.high, row.center + size);
  }
  return box;
}

// Divided by counts.
Swept sweep_by_counts(std::span<const Curve2> contour, const Curve3& given, const SweepOptions& options) {
  const ContourSamplers samplers = make_samplers(contour, options.morph, options.crease_deg, options.uv.by,
                                                 OutlineSampler::PiecesBy::kCorners);
  Swept swept;
  swept.outer_of = samplers.outer_of;
  const auto [trajectory, least_cells] = join_corners(given, samplers, options);
  const std::vector<Station> stations =
      place_stations(trajectory, options.tessellation.trajectory, least_cells);
  CountedSweep counted =
      make_counted_sweep(samplers, options.tessellation.contour, trajectory, stations, options);
  swept.morphs = std::move(counted.morphs);
  swept.spine = std::move(counted.spine);
  for (std::size_t i = 0; i < swept.morphs.size(); ++i) {
    swept.closing_columns.push_back(closing_columns(swept.morphs[i], swept.spine, swept.outer_of[i] != i));
  }
  return swept;
}

// Divided far too finely, and thinned out to a tolerance.
Swept sweep_to_tolerance(std::span<const Curve2> contour, const Curve3& given, const SweepOptions& options,
                         double tolerance) {
  ContourSamplers samplers = make_samplers(contour, options.morph, options.crease_deg, options.uv.by,
                                           OutlineSampler::PiecesBy::kSegments);
  if (given.is_closed()) make_periodic(samplers);
  DenseSweep dense = make_dense_sweep(samplers, given, options, tolerance, 0);
  const Box box = box_of(dense.spine, reach_of(dense.morphs));
  const double left = tolerance_left(tolerance, box);
  Swept swept;
  swept.outer_of = dense.outer_of;
  // What a dome misses between its columns and between its rows may add up.
  const bool has_domes = options.caps == Caps::kRound && !given.is_closed();
  const double columns_share = has_domes ? 0.5 : 1;
  swept.dome_tolerance = (1 - columns_share) * left;
  swept.grid = fit_grid(dense, left, columns_share);
  // Cells that twist may be as small as those of the dense sweep: then it is too coarse to tell.
  for (int density = 1; !is_well_measured(dense, *swept.grid, left) && density <= kMostDensity; ++density) {
    dense = make_dense_sweep(samplers, given, options, tolerance, density);
    swept.grid = fit_grid(dense, left, columns_share);
  }
  if (swept.grid->deviation > left) {
    throw InputError("tolerance of " + number_text(tolerance) +
                     " m is not reached with the most cells there may be, " +
                     number_text(swept.grid->deviation) + " m is; ask for a larger one");
  }
  // As chosen, a dome misses that much between its rows and as much between its columns.
  if (has_domes) swept.grid->deviation = std::max(swept.grid->deviation, 2 * swept.dome_tolerance);
  swept.grid->deviation += float_error(box);
  std::uint64_t columns_of_all = 0;
  for (const std::vector<std::size_t>& columns : swept.grid->columns) columns_of_all += columns.size() - 1;
  check_triangles(options.tessellation, 2 * columns_of_all * (swept.grid->rows.size() - 1));
  swept.spine = kept_rows(dense.spine, swept.grid->rows);
  for (std::size_t i = 0; i < dense.morphs.size(); ++i) {
    const std::vector<std::size_t>& columns = swept.grid->columns[i];
    swept.morphs.push_back(kept_columns(dense.morphs[i], columns));
    const auto home = std::lower_bound(columns.begin(), columns.end(), dense.closing_columns[i]);
    swept.closing_columns.push_back(static_cast<std::size_t>(home - columns.begin()));
  }
  return swept;
}

// A section that the profile has shrunk to a point or pressed flat is closed without a cap.
bool needs_cap(const Row& row) {
  return glm::length(row.x_axis) > 0 && glm::length(row.y_axis) > 0;
}

// Rows of a dome: as many cells as over a quarter of the contour and enough to look round, or within the
// tolerance: a circle's arc of n cells to the quarter is off by r (1 - cos(45 degrees / n)).
std::uint32_t dome_rows(const Swept& swept, const Row& row, const SweepOptions& options) {
  if (!options.tessellation.tolerance) {
    return static_cast<std::uint32_t>(std::max<std::size_t>(4, (swept.morphs.front().columns() + 3) / 4));
  }
  const double radius = reach_of(swept.morphs) * std::max(glm::length(row.x_axis), glm::length(row.y_axis));
  const double share = std::clamp(swept.dome_tolerance / radius, 1e-10, 0.5);
  return static_cast<std::uint32_t>(std::ceil(std::numbers::pi / 4 / std::acos(1 - share)));
}

// `uv` is that of the wall's first outline.
void add_cap(Mesh& mesh, std::span<const Curve2> contour, const Swept& swept, End end,
             const SweepOptions& options, const UvOptions& uv) {
  const bool is_first = end == End::kFirst;
  const Row& row = is_first ? swept.spine.rows.front() : swept.spine.rows.back();
  if (!needs_cap(row)) return;
  std::vector<Section> sections;
  sections.reserve(swept.morphs.size());
  for (const Morph& morph : swept.morphs) sections.push_back(section_at(morph, is_first ? 0 : 1));
  if (options.caps == Caps::kRound) {
    // Of a section that is always as fine: however coarse the mesh is, the dome is the same.
    const ContourSamplers samplers = make_samplers(contour, options.morph, options.crease_deg, options.uv.by,
                                                   OutlineSampler::PiecesBy::kCorners);
    const Section fine = section_at(sample(samplers, kShapeCells).front(), is_first ? 0 : 1);
    add_round_cap(mesh, sections.front(), row, end, dome_over(fine, row), dome_rows(swept, row, options), uv);
    return;
  }
  // Seen from outside the first cap shows the contour mirrored.
  const glm::dvec3 outwards = is_first ? -row.out.frame.tangent : row.in.frame.tangent;
  add_flat_caps(mesh, sections, swept.outer_of, {row.center, row.x_axis, row.y_axis, outwards}, is_first);
}

}  // namespace

Mesh sweep(std::span<const Curve2> contour, const Curve3& trajectory, const SweepOptions& options) {
  check_options(contour, options);
  const std::optional<double> tolerance = options.tessellation.tolerance;
  const Swept swept = tolerance ? sweep_to_tolerance(contour, trajectory, options, *tolerance)
                                : sweep_by_counts(contour, trajectory, options);
  Mesh mesh;
  mesh.origin = choose_origin(box_of(swept.spine, reach_of(swept.morphs)));
  const auto uv_of = [&](std::size_t outline) {
    return with_repeats(options.uv, {contour[outline].length(), contour[outline].is_closed()},
                        {swept.spine.length, trajectory.is_closed()});
  };
  for (std::size_t i = 0; i < swept.morphs.size(); ++i) {
    const Wall wall{swept.morphs[i], split_runs(swept.morphs[i].keys.front().breaks),
                    swept.closing_columns[i]};
    add_wall(mesh, wall, swept.spine, uv_of(i));
  }
  if (mesh.triangles.empty()) {
    throw InputError(
        "profile is 0 at every row of the mesh, which leaves no surface; let it be above 0 somewhere, or "
        "ask for more cells along the trajectory");
  }
  if (options.caps != Caps::kNone && contour.front().is_closed() && !trajectory.is_closed()) {
    add_cap(mesh, contour, swept, End::kFirst, options, uv_of(0));
    add_cap(mesh, contour, swept, End::kLast, options, uv_of(0));
  }
  if (swept.grid) mesh.deviation = swept.grid->deviation;
  if (options.has_half_edges) write_half_edges(mesh);
  return mesh;
}

Mesh sweep(const Curve2& contour, const Curve3& trajectory, const SweepOptions& options) {
  return sweep(std::span(&contour, 1), trajectory, options);
}

}  // namespace sweepkit::sweep
