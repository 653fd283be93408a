// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The general sweep of Akman and Arslan (1992), profiled and twisted:
//   S(s, t) = c(t) + x(s) X(t) + y(s) Y(t)
// and its normal from the derivatives, t measured by arc length (rows.cpp says what X and Y are). Away from
// mitres, profile and twist that is
//   dS/ds x dS/dt = a (y' N - x' B),   a = 1 - x kN - y kB,
// kN and kB the curvature. a < 0 where the contour reaches past the centre of curvature and the surface folds
// over; the normal keeps to the contour's outside there. At a pole dS/ds is 0 and its direction takes its
// place.

#include "sweepkit/sweep/sweep.hpp"

#include <algorithm>
#include <utility>

#include "cap_writer.hpp"
#include "grid_writer.hpp"
#include "half_edges.hpp"
#include "joints.hpp"
#include "number_text.hpp"
#include "orientation.hpp"
#include "rows.hpp"
#include "section.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

glm::dvec3 point_of(const Row& row, const glm::dvec2& p) {
  return row.center + p.x * row.x_axis + p.y * row.y_axis;
}

glm::dvec3 normal_of(const Row& row, const RowSide& side, const glm::dvec2& p, const glm::dvec2& tangent) {
  const Frame& f = side.frame;
  // Where only the trajectory bends, both derivatives lie in planes that this is perpendicular to.
  if (side.is_plain) return tangent.y * f.normal - tangent.x * f.binormal;
  const glm::dvec3 across = tangent.x * row.x_direction + tangent.y * row.y_direction;
  const glm::dvec3 ahead = f.tangent + p.x * side.x_rate + p.y * side.y_rate;
  const glm::dvec3 outward = glm::cross(across, f.tangent);
  const glm::dvec3 normal = glm::cross(across, ahead);
  const double length = glm::length(normal);
  if (length > 1e-12 * glm::length(ahead)) return (glm::dot(normal, outward) < 0 ? -normal : normal) / length;
  const double width = glm::length(outward);
  return width > 0 ? outward / width : tangent.y * f.normal - tangent.x * f.binormal;
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

// What a wall is written from: the section's columns, the rows, and where both break.
struct Wall {
  Section section;
  std::vector<Row> rows;
  std::vector<bool> breaks;  // of the normal, a row
  std::vector<bool> poles;
  std::vector<double> v_fractions;
  std::vector<Run> column_runs;
  std::vector<Run> row_runs;
  // A closed trajectory's last row is its first one's vertices, so many columns on.
  std::size_t closing_columns = 0;
  glm::dvec2 repeat{1.0};
};

glm::dvec3 middle_of(const Wall& wall) {
  const double reach = reach_of(wall.section);
  glm::dvec3 low = wall.rows.front().center;
  glm::dvec3 high = low;
  for (const Row& row : wall.rows) {
    const double size = reach * std::max(glm::length(row.x_axis), glm::length(row.y_axis));
    low = glm::min(low, row.center - size);
    high = glm::max(high, row.center + size);
  }
  return choose_origin(low, high);
}

void write_wall(Mesh& mesh, const Wall& wall) {
  const std::span<glm::vec3> positions = mesh.positions();
  const std::span<glm::vec3> normals = mesh.normals();
  const std::span<glm::vec2> texcoords = mesh.texcoords();
  const std::size_t columns = wall.section.points.size() - 1;
  for_each_wall_vertex(
      0, wall.column_runs, wall.row_runs, wall.poles,
      [&](std::size_t vertex, std::size_t i, std::size_t j, const Run& column_run, const Run& row_run) {
        const Row& row = wall.rows[j];
        const bool is_home = j + 1 == wall.rows.size() && wall.closing_columns > 0;
        const SectionPoint& point = wall.section.points[is_home ? (i + wall.closing_columns) % columns : i];
        const glm::dvec2& tangent = i == column_run.first ? point.tangent_out : point.tangent_in;
        // A corner that breaks shows the side this run lies on; one that does not shows the middle of both.
        const RowSide& side = j == row_run.first && wall.breaks[j] ? row.out : row.in;
        glm::dvec3 normal = normal_of(row, side, point.position, tangent);
        if (row.is_corner && !wall.breaks[j])
          normal = glm::normalize(normal + normal_of(row, row.out, point.position, tangent));
        positions[vertex] = glm::vec3(point_of(row, point.position) - mesh.origin);
        normals[vertex] = glm::vec3(normal);
        texcoords[vertex] = {static_cast<float>(wall.section.fractions[i] * wall.repeat.x),
                             static_cast<float>(wall.v_fractions[j] * wall.repeat.y)};
      });
}

}  // namespace

Mesh sweep(const Curve2& contour, const Curve3& given_trajectory, const SweepOptions& options) {
  check_cells(options.tessellation.contour, "contour");
  check_cells(options.tessellation.trajectory, "trajectory");
  check_texture(options.uv);
  if (!(options.miter_limit >= 1)) {
    throw InputError("miter_limit needs to be 1 or more, got " + number_text(options.miter_limit));
  }
  Section section = make_section(contour, options.tessellation.contour, options.crease_deg, options.uv.by);
  const double reach = reach_of(section);
  const auto [trajectory, least_cells] =
      join_corners(given_trajectory, options.joints, options.miter_limit, [&](double length) {
        const double t = length / given_trajectory.length();
        return reach * std::max(options.profile.x.at(t).value, options.profile.y.at(t).value);
      });
  const std::vector<Station> stations =
      place_stations(trajectory, options.tessellation.trajectory, least_cells);
  if (trajectory.is_closed()) check_loop(stations.size() - 1, "trajectory");
  const int symmetry = trajectory.is_closed() ? symmetry_of(section) : 1;
  const Oriented oriented = orient(trajectory, stations, options.orientation, options.twist_deg, symmetry);
  std::vector<Row> rows = make_rows(trajectory, stations, oriented.frames, options.profile);
  std::vector<bool> breaks = row_breaks(rows, options);
  std::vector<bool> poles(rows.size());
  std::transform(rows.begin(), rows.end(), poles.begin(), [](const Row& row) { return row.is_pole; });
  std::vector<Run> column_runs = split_runs(section.breaks);
  std::vector<Run> row_runs = split_runs(breaks);
  const auto columns = static_cast<int>(section.points.size()) - 1;
  const int steps = (oriented.closing_steps % symmetry + symmetry) % symmetry;
  const Wall wall{std::move(section),
                  std::move(rows),
                  std::move(breaks),
                  std::move(poles),
                  texture_fractions(stations, options.uv.by),
                  std::move(column_runs),
                  std::move(row_runs),
                  static_cast<std::size_t>(columns / symmetry * steps),
                  options.uv.repeat};

  Mesh mesh;
  mesh.origin = middle_of(wall);
  const glm::dvec2 period(wall.section.is_closed ? options.uv.repeat.x : 0,
                          trajectory.is_closed() ? options.uv.repeat.y : 0);
  lay_out_wall(mesh, wall.column_runs, wall.row_runs, wall.poles, period);
  write_wall(mesh, wall);
  if (options.caps == Caps::kFlat && wall.section.is_closed && !trajectory.is_closed()) {
    // Seen from outside the first cap shows the contour mirrored.
    const Row& first = wall.rows.front();
    const Row& last = wall.rows.back();
    if (!first.is_pole)
      add_cap(mesh, wall.section, {first.center, first.x_axis, first.y_axis, -first.out.frame.tangent}, true);
    if (!last.is_pole)
      add_cap(mesh, wall.section, {last.center, last.x_axis, last.y_axis, last.in.frame.tangent}, false);
  }
  if (options.has_half_edges) write_half_edges(mesh);
  return mesh;
}

}  // namespace sweepkit::sweep
