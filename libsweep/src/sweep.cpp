// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The general sweep of Akman and Arslan (1992), with rotation-minimizing frames:
//   S(s, t) = c(t) + x(s) X(t) + y(s) Y(t)
// and its normal from the derivatives, t measured by arc length (rows.cpp says what X and Y are). Away from
// mitres that is
//   dS/ds x dS/dt = a (y' N - x' B) + w (x x' + y y') T,   a = 1 - x kN - y kB,
// kN and kB the curvature, w the rate of a closed trajectory's twist. a < 0 where the contour reaches past
// the centre of curvature and the surface folds over; the normal keeps to the contour's outside there.

#include "sweepkit/sweep/sweep.hpp"

#include <algorithm>
#include <utility>

#include "cap_writer.hpp"
#include "grid_writer.hpp"
#include "half_edges.hpp"
#include "rotation_minimizing_frames.hpp"
#include "rows.hpp"
#include "section.hpp"

namespace sweepkit::sweep {
namespace {

glm::dvec3 point_of(const Row& row, const glm::dvec2& p) {
  return row.center + p.x * row.x_axis + p.y * row.y_axis;
}

glm::dvec3 normal_of(const Row& row, const RowSide& side, double closing_rate, const glm::dvec2& p,
                     const glm::dvec2& tangent) {
  const Frame& f = side.frame;
  const glm::dvec3 outward = tangent.y * f.normal - tangent.x * f.binormal;
  // Without a twist both derivatives lie in planes that `outward` is perpendicular to.
  if (closing_rate == 0) return outward;
  const glm::dvec3 across = tangent.x * row.x_axis + tangent.y * row.y_axis;
  const glm::dvec3 ahead = f.tangent + p.x * side.x_rate + p.y * side.y_rate;
  const glm::dvec3 normal = glm::cross(across, ahead);
  const double length = glm::length(normal);
  if (!(length > 1e-12)) return outward;
  return (glm::dot(normal, outward) < 0 ? -normal : normal) / length;
}

std::vector<bool> row_breaks(const std::vector<Row>& rows, double crease_deg) {
  const double crease_cos = crease_cosine(crease_deg);
  std::vector<bool> breaks;
  breaks.reserve(rows.size());
  for (const Row& row : rows) {
    breaks.push_back(row.is_corner && glm::dot(row.in.frame.tangent, row.out.frame.tangent) < crease_cos);
  }
  return breaks;
}

// What a wall is written from: the section's columns, the rows, and where both break.
struct Wall {
  Section section;
  std::vector<Row> rows;
  std::vector<bool> breaks;  // of the normal, a row
  std::vector<double> v_fractions;
  std::vector<Run> column_runs;
  std::vector<Run> row_runs;
  double closing_rate = 0;
  glm::dvec2 repeat{1.0};
};

glm::dvec3 middle_of(const Wall& wall) {
  double reach = 0;
  for (const SectionPoint& point : wall.section.points) reach = std::max(reach, glm::length(point.position));
  glm::dvec3 low = wall.rows.front().center;
  glm::dvec3 high = low;
  for (const Row& row : wall.rows) {
    low = glm::min(low, row.center - reach);
    high = glm::max(high, row.center + reach);
  }
  return choose_origin(low, high);
}

void write_wall(Mesh& mesh, const Wall& wall) {
  const std::span<glm::vec3> positions = mesh.positions();
  const std::span<glm::vec3> normals = mesh.normals();
  const std::span<glm::vec2> texcoords = mesh.texcoords();
  std::size_t vertex = mesh.patches.front().first_vertex;
  for (const Run& row_run : wall.row_runs) {
    for (const Run& column_run : wall.column_runs) {
      for (std::size_t j = row_run.first; j <= row_run.last; ++j) {
        const Row& row = wall.rows[j];
        // A corner that breaks shows the side this run lies on; one that does not shows the middle of both.
        const bool is_middle = row.is_corner && !wall.breaks[j];
        const RowSide& side = j == row_run.first && wall.breaks[j] ? row.out : row.in;
        const auto v = static_cast<float>(wall.v_fractions[j] * wall.repeat.y);
        for (std::size_t i = column_run.first; i <= column_run.last; ++i, ++vertex) {
          const SectionPoint& point = wall.section.points[i];
          const glm::dvec2& tangent = i == column_run.first ? point.tangent_out : point.tangent_in;
          glm::dvec3 normal = normal_of(row, side, wall.closing_rate, point.position, tangent);
          if (is_middle)
            normal =
                glm::normalize(normal + normal_of(row, row.out, wall.closing_rate, point.position, tangent));
          positions[vertex] = glm::vec3(point_of(row, point.position) - mesh.origin);
          normals[vertex] = glm::vec3(normal);
          texcoords[vertex] = {static_cast<float>(wall.section.fractions[i] * wall.repeat.x), v};
        }
      }
    }
  }
}

}  // namespace

Mesh sweep(const Curve2& contour, const Curve3& trajectory, const SweepOptions& options) {
  check_cells(options.tessellation.contour, "contour");
  check_cells(options.tessellation.trajectory, "trajectory");
  check_texture(options.uv);
  Section section = make_section(contour, options.tessellation.contour, options.crease_deg, options.uv.by);
  const std::vector<Station> stations = place_stations(trajectory, options.tessellation.trajectory);
  if (trajectory.is_closed()) check_loop(stations.size() - 1, "trajectory");
  const FramesAlong along = rotation_minimizing_frames(trajectory, stations);
  std::vector<Row> rows = make_rows(trajectory, stations, along);
  std::vector<bool> breaks = row_breaks(rows, options.crease_deg);
  std::vector<Run> column_runs = split_runs(section.breaks);
  std::vector<Run> row_runs = split_runs(breaks);
  const Wall wall{std::move(section),     std::move(rows),
                  std::move(breaks),      texture_fractions(stations, options.uv.by),
                  std::move(column_runs), std::move(row_runs),
                  along.closing_rate,     options.uv.repeat};

  Mesh mesh;
  mesh.origin = middle_of(wall);
  const glm::dvec2 period(wall.section.is_closed ? options.uv.repeat.x : 0,
                          trajectory.is_closed() ? options.uv.repeat.y : 0);
  lay_out_wall(mesh, wall.column_runs, wall.row_runs, std::vector<bool>(wall.rows.size(), false), period);
  write_wall(mesh, wall);
  if (options.caps == Caps::kFlat && wall.section.is_closed && !trajectory.is_closed()) {
    // Seen from outside the first cap shows the contour mirrored.
    const Row& first = wall.rows.front();
    const Row& last = wall.rows.back();
    add_cap(mesh, wall.section, {first.center, first.x_axis, first.y_axis, -first.out.frame.tangent}, true);
    add_cap(mesh, wall.section, {last.center, last.x_axis, last.y_axis, last.in.frame.tangent}, false);
  }
  if (options.has_half_edges) write_half_edges(mesh);
  return mesh;
}

}  // namespace sweepkit::sweep
