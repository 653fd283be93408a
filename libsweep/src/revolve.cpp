// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A contour (r, h) turned about +Y: S(a, s) = (r cos a, h, -r sin a). The normal is the contour's own
// right-hand normal (h', -r') turned along; it needs no radius, so it is finite and right at a pole too.

#include "sweepkit/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "dense_sweep.hpp"
#include "flat_cap.hpp"
#include "float_positions.hpp"
#include "grid_writer.hpp"
#include "half_edges.hpp"
#include "number_text.hpp"
#include "outline_sampler.hpp"
#include "revolve_tolerance.hpp"
#include "section.hpp"
#include "sweepkit/error.hpp"
#include "texture_repeats.hpp"
#include "whole_angle.hpp"

namespace sweepkit::sweep {
namespace {

// A radius below this share of the contour's size was meant to be 0: it is what rounding leaves of it.
constexpr double kOnAxis = 1e-12;

void snap_to_axis(std::vector<Section>& sections) {
  double size = 0;
  for (const Section& section : sections) {
    for (const SectionPoint& point : section.points) size = std::max(size, std::abs(point.position.x));
  }
  for (Section& section : sections) {
    bool is_on_axis = true;
    for (SectionPoint& point : section.points) {
      if (std::abs(point.position.x) <= kOnAxis * size) point.position.x = 0;
      is_on_axis = is_on_axis && point.position.x == 0;
      if (point.position.x < 0) {
        throw InputError("contour crosses the axis: x is " + number_text(point.position.x) + " m at height " +
                         number_text(point.position.y) + " m; keep x, the distance from it, at 0 or above");
      }
    }
    if (is_on_axis) {
      throw InputError("contour has all its " + std::to_string(section.points.size()) +
                       " vertices on the axis; move it away from x = 0 or give it more cells");
    }
  }
}

// The half plane at an angle of the turn, which goes along (-sin, 0, -cos) there.
CapPlane half_plane(double angle_deg, bool is_first) {
  const auto [c, s] = cos_sin_deg(angle_deg);
  const glm::dvec3 ahead(-s, 0, -c);
  return {glm::dvec3(0.0), {c, 0, -s}, {0, 1, 0}, is_first ? -ahead : ahead};
}

// The columns of the turn.
struct Turn {
  std::vector<CosSin> at;
  std::vector<float> u;
  bool is_whole;
};

Turn make_turn(const RevolveOptions& options, double u_repeats, int columns) {
  Turn turn{{}, {}, options.angle_deg == 360};
  for (int i = 0; i <= columns; ++i) {
    turn.at.push_back(turn.is_whole  ? cos_sin_turn(i, columns)
                      : i == columns ? cos_sin_deg(options.angle_deg)
                                     : cos_sin_deg(options.angle_deg * i / columns));
    turn.u.push_back(static_cast<float>(u_repeats * i / columns));
  }
  return turn;
}

Box box_of(const std::vector<Section>& sections) {
  double radius = 0;
  double low = sections.front().points.front().position.y;
  double high = low;
  for (const Section& section : sections) {
    for (const SectionPoint& point : section.points) {
      radius = std::max(radius, point.position.x);
      low = std::min(low, point.position.y);
      high = std::max(high, point.position.y);
    }
  }
  return {{-radius, low, -radius}, {radius, high, radius}};
}

void add_wall(Mesh& mesh, const Section& section, const Turn& turn, const UvOptions& uv) {
  Poles poles(1);
  std::vector<bool> breaks = section.breaks;
  for (std::size_t j = 0; j < breaks.size(); ++j) {
    poles.front().push_back(section.points[j].position.x == 0);
    if (poles.front()[j]) breaks[j] = true;
  }
  const std::vector<Run> column_runs = {{0, turn.at.size() - 1}};
  const std::vector<Run> row_runs = split_runs(breaks);
  const auto first = static_cast<std::uint32_t>(mesh.n_vertices());
  lay_out_wall(mesh, column_runs, row_runs, poles,
               {turn.is_whole ? uv.repeat.x : 0, section.is_closed ? uv.repeat.y : 0});
  const std::span<glm::vec3> positions = mesh.positions();
  const std::span<glm::vec3> normals = mesh.normals();
  const std::span<glm::vec2> texcoords = mesh.texcoords();
  for_each_wall_row(first, column_runs, row_runs, poles,
                    [&](std::size_t vertex, std::size_t, std::size_t j, std::size_t first_column,
                        std::size_t last_column, bool begins_run) {
                      const SectionPoint& point = section.points[j];
                      const glm::dvec2& tangent = begins_run ? point.tangent_out : point.tangent_in;
                      const double r = point.position.x;
                      const auto v = static_cast<float>(section.fractions[j] * uv.repeat.y);
                      for (std::size_t i = first_column; i <= last_column; ++i, ++vertex) {
                        const auto [c, s] = turn.at[i];
                        positions[vertex] =
                            glm::vec3(glm::dvec3(r * c, point.position.y, -r * s) - mesh.origin);
                        normals[vertex] = glm::vec3(glm::dvec3(tangent.y * c, -tangent.x, -tangent.y * s));
                        texcoords[vertex] = {turn.u[i], v};
                      }
                    });
}

void check_options(const RevolveOptions& options) {
  check_cells(options.tessellation.contour, "contour");
  check_cells(options.tessellation.trajectory, "turn");
  check_tolerance(options.tessellation.tolerance);
  if (!(options.angle_deg > 0 && options.angle_deg <= 360)) {
    throw InputError("angle_deg needs to be above 0 and at most 360, got " + number_text(options.angle_deg));
  }
  if (options.angle_deg == 360) {
    check_loop(static_cast<std::size_t>(options.tessellation.trajectory), "the whole turn");
  }
  if (options.caps == Caps::kRound) throw InputError("caps of a turned contour are flat or none, not round");
  check_texture(options.uv);
}

}  // namespace

Mesh revolve(std::span<const Curve2> contour, const RevolveOptions& options) {
  check_options(options);
  const std::optional<double> tolerance = options.tessellation.tolerance;
  using PiecesBy = OutlineSampler::PiecesBy;
  const ContourSamplers samplers = make_samplers(contour, {}, options.crease_deg, options.uv.by,
                                                 tolerance ? PiecesBy::kSegments : PiecesBy::kCorners);
  std::vector<Section> sections;
  for (Morph& morph : tolerance ? sample_densely(samplers, kDenseShare * *tolerance, *tolerance, 1)
                                : sample(samplers, options.tessellation.contour)) {
    sections.push_back(std::move(morph.keys.front()));
  }
  snap_to_axis(sections);
  const Box box = box_of(sections);
  int columns = options.tessellation.trajectory;
  std::optional<double> deviation;
  if (tolerance) {
    TurnedGrid grid = fit_turned_grid(sections, options.angle_deg, tolerance_left(*tolerance, box));
    sections = std::move(grid.sections);
    columns = grid.columns;
    std::uint64_t rows = 0;
    for (const Section& section : sections) rows += section.points.size() - 1;
    check_triangles(options.tessellation, 2 * rows * static_cast<std::uint64_t>(columns));
    deviation = grid.deviation + float_error(box);
  }
  const bool is_whole = options.angle_deg == 360;
  const Extent round_the_turn{box.high.x * options.angle_deg * (std::numbers::pi / 180), is_whole};
  const auto uv_of = [&](std::size_t outline) {
    return with_repeats(options.uv, round_the_turn,
                        {contour[outline].length(), contour[outline].is_closed()});
  };
  const Turn turn = make_turn(options, uv_of(0).repeat.x, columns);

  Mesh mesh;
  mesh.origin = choose_origin(box);
  for (std::size_t i = 0; i < sections.size(); ++i) add_wall(mesh, sections[i], turn, uv_of(i));
  if (options.caps == Caps::kFlat && sections.front().is_closed && !turn.is_whole) {
    add_flat_caps(mesh, sections, samplers.outer_of, half_plane(0, true), false);
    add_flat_caps(mesh, sections, samplers.outer_of, half_plane(options.angle_deg, false), true);
  }
  mesh.deviation = deviation;
  if (options.has_half_edges) write_half_edges(mesh);
  return mesh;
}

Mesh revolve(const Curve2& contour, const RevolveOptions& options) {
  return revolve(std::span(&contour, 1), options);
}

}  // namespace sweepkit::sweep
