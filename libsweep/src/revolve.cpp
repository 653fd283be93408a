// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A contour (r, h) turned about +Y: S(a, s) = (r cos a, h, -r sin a). The normal is the contour's own
// right-hand normal (h', -r') turned along; it needs no radius, so it is finite and right at a pole too.

#include "sweepkit/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "cap_writer.hpp"
#include "grid_writer.hpp"
#include "half_edges.hpp"
#include "number_text.hpp"
#include "section.hpp"
#include "sweepkit/error.hpp"
#include "whole_angle.hpp"

namespace sweepkit::sweep {
namespace {

// A radius below this share of the contour's size was meant to be 0: it is what rounding leaves of it.
constexpr double kOnAxis = 1e-12;

void snap_to_axis(Section& section) {
  double size = 0;
  for (const SectionPoint& point : section.points) size = std::max(size, std::abs(point.position.x));
  for (SectionPoint& point : section.points) {
    if (std::abs(point.position.x) <= kOnAxis * size) point.position.x = 0;
    if (point.position.x < 0) {
      throw InputError("contour crosses the axis: x is " + number_text(point.position.x) + " m at height " +
                       number_text(point.position.y) + " m; keep x, the distance from it, at 0 or above");
    }
  }
  if (!(size > 0)) {
    throw InputError("contour has all its " + std::to_string(section.points.size()) +
                     " vertices on the axis; move it away from x = 0 or give it more cells");
  }
}

// The half plane at an angle of the turn, which goes along (-sin, 0, -cos) there.
CapPlane half_plane(double angle_deg, bool is_first) {
  const auto [c, s] = cos_sin_deg(angle_deg);
  const glm::dvec3 ahead(-s, 0, -c);
  return {glm::dvec3(0.0), {c, 0, -s}, {0, 1, 0}, is_first ? -ahead : ahead};
}

}  // namespace

Mesh revolve(const Curve2& contour, const RevolveOptions& options) {
  check_cells(options.tessellation.contour, "contour");
  check_cells(options.tessellation.trajectory, "turn");
  if (!(options.angle_deg > 0 && options.angle_deg <= 360)) {
    throw InputError("angle_deg needs to be above 0 and at most 360, got " + number_text(options.angle_deg));
  }
  const bool is_whole = options.angle_deg == 360;
  const int columns = options.tessellation.trajectory;
  if (is_whole) check_loop(static_cast<std::size_t>(columns), "the whole turn");
  check_texture(options.uv);
  Section section = make_section(contour, options.tessellation.contour, options.crease_deg, options.uv.by);
  snap_to_axis(section);

  const std::size_t row_count = section.points.size();
  std::vector<bool> poles(row_count);
  std::vector<bool> breaks = section.breaks;
  glm::dvec3 low(0.0);
  glm::dvec3 high(0.0);
  double radius = 0;
  low.y = high.y = section.points.front().position.y;
  for (std::size_t j = 0; j < row_count; ++j) {
    const glm::dvec2& p = section.points[j].position;
    poles[j] = p.x == 0;
    if (poles[j]) breaks[j] = true;
    radius = std::max(radius, p.x);
    low.y = std::min(low.y, p.y);
    high.y = std::max(high.y, p.y);
  }
  low.x = low.z = -radius;
  high.x = high.z = radius;

  Mesh mesh;
  mesh.origin = choose_origin(low, high);
  const std::vector<bool> turn_breaks(static_cast<std::size_t>(columns) + 1, false);
  const std::vector<Run> column_runs = split_runs(turn_breaks);
  const std::vector<Run> row_runs = split_runs(breaks);
  const glm::dvec2 period(is_whole ? options.uv.repeat.x : 0, section.is_closed ? options.uv.repeat.y : 0);
  lay_out_wall(mesh, column_runs, row_runs, poles, period);

  std::vector<CosSin> turn;
  std::vector<float> u;
  for (int i = 0; i <= columns; ++i) {
    turn.push_back(is_whole       ? cos_sin_turn(i, columns)
                   : i == columns ? cos_sin_deg(options.angle_deg)
                                  : cos_sin_deg(options.angle_deg * i / columns));
    u.push_back(static_cast<float>(options.uv.repeat.x * i / columns));
  }
  const std::span<glm::vec3> positions = mesh.positions();
  const std::span<glm::vec3> normals = mesh.normals();
  const std::span<glm::vec2> texcoords = mesh.texcoords();
  for_each_wall_vertex(
      0, column_runs, row_runs, poles,
      [&](std::size_t vertex, std::size_t i, std::size_t j, const Run&, const Run& run) {
        const SectionPoint& point = section.points[j];
        const glm::dvec2& tangent = j == run.first ? point.tangent_out : point.tangent_in;
        const double r = point.position.x;
        const auto [c, s] = turn[i];
        positions[vertex] = glm::vec3(glm::dvec3(r * c, point.position.y, -r * s) - mesh.origin);
        normals[vertex] = glm::vec3(glm::dvec3(tangent.y * c, -tangent.x, -tangent.y * s));
        texcoords[vertex] = {u[i], static_cast<float>(section.fractions[j] * options.uv.repeat.y)};
      });
  if (options.caps == Caps::kFlat && section.is_closed && !is_whole) {
    add_cap(mesh, section, half_plane(0, true), false);
    add_cap(mesh, section, half_plane(options.angle_deg, false), true);
  }
  if (options.has_half_edges) write_half_edges(mesh);
  return mesh;
}

}  // namespace sweepkit::sweep
