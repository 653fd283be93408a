// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// With g the section's centroid, h the dome's height and n outwards along the trajectory
//   D(s, a) = c + g + cos(a) (p(s) - g) + h sin(a) n,   a from 0 at the ring to 90 degrees at the pole:
// a hemisphere over a circle, half of an ellipsoid over an ellipse. Every layer is the section made smaller
// at a height of its own, so a dome over any outline that does not cross itself does not either.

#include "round_cap.hpp"

#include <cmath>
#include <vector>

#include "grid_writer.hpp"
#include "triangulate.hpp"
#include "wall.hpp"
#include "whole_angle.hpp"

namespace sweepkit::sweep {
namespace {

glm::dvec2 centroid_of(const std::vector<glm::dvec2>& outline) {
  glm::dvec2 sum(0.0);
  double area = 0;
  const glm::dvec2& about = outline.front();
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const glm::dvec2 a = outline[i] - about;
    const glm::dvec2 b = outline[i + 1] - about;
    const double twice = a.x * b.y - a.y * b.x;
    area += twice;
    sum += twice * (a + b);
  }
  return area != 0 ? about + sum / (3 * area) : about;
}

// The outline's mean distance from g.
double dome_height(const Section& section, const Row& row, const glm::dvec2& g) {
  double sum = 0;
  double length = 0;
  const auto from_axis = [&](std::size_t i) {
    const glm::dvec2 p = section.points[i].position - g;
    return p.x * row.x_axis + p.y * row.y_axis;
  };
  for (std::size_t i = 0; i + 1 < section.points.size(); ++i) {
    const glm::dvec3 a = from_axis(i);
    const glm::dvec3 b = from_axis(i + 1);
    sum += glm::length(b - a) * 0.5 * (glm::length(a) + glm::length(b));
    length += glm::length(b - a);
  }
  return sum / length;
}

}  // namespace

Dome dome_over(const Section& section, const Row& row) {
  const glm::dvec2 g = centroid_of(outline_of(section));
  return {g, dome_height(section, row, g)};
}

void add_round_cap(Mesh& mesh, const Section& section, const Row& row, End end, const Dome& dome,
                   std::uint32_t rows, const UvOptions& uv) {
  const bool is_first = end == End::kFirst;
  const glm::dvec3 tangent = is_first ? row.out.frame.tangent : row.in.frame.tangent;
  const glm::dvec3 outwards = is_first ? -tangent : tangent;
  const glm::dvec2 g = dome.middle;
  const double height = dome.height;
  const std::vector<Run> column_runs = split_runs(section.breaks);
  const std::vector<Run> row_runs = {{0, rows}};
  std::vector<bool> pole_rows(rows + 1, false);
  if (is_first) {
    pole_rows.front() = true;
  } else {
    pole_rows.back() = true;
  }
  const Poles poles(column_runs.size(), pole_rows);
  const auto first_vertex = static_cast<std::uint32_t>(mesh.n_vertices());
  lay_out_wall(mesh, column_runs, row_runs, poles, {uv.repeat.x, 0});
  for_each_wall_row(
      first_vertex, column_runs, row_runs, poles,
      [&](std::size_t vertex, std::size_t run, std::size_t j, std::size_t first_column,
          std::size_t last_column, bool) {
        const auto layer = static_cast<int>(is_first ? rows - j : j);
        const auto [c, s] = cos_sin_turn(layer, 4 * static_cast<int>(rows));
        const float v = static_cast<float>(j) / static_cast<float>(rows);
        for (std::size_t i = first_column; i <= last_column; ++i, ++vertex) {
          const SectionPoint& point = section.points[i];
          const glm::dvec2 p = g + c * (point.position - g);
          const glm::dvec3 position =
              layer == 0 ? position_of(row, point.position) : position_of(row, p) + height * s * outwards;
          const glm::dvec2& along = i == column_runs[run].first ? point.tangent_out : point.tangent_in;
          const glm::dvec3 across = along.x * row.x_axis + along.y * row.y_axis;
          const glm::dvec2 from_axis = point.position - g;
          const glm::dvec3 inwards = from_axis.x * row.x_axis + from_axis.y * row.y_axis;
          const glm::dvec3 ahead = height * c * tangent + (is_first ? s : -s) * inwards;
          const glm::dvec3 normal = glm::cross(across, ahead);
          const double length = glm::length(normal);
          const bool is_pole = layer == static_cast<int>(rows) || !(length > 0);
          mesh.positions()[vertex] = glm::vec3(position - mesh.origin);
          mesh.normals()[vertex] = glm::vec3(is_pole ? outwards : normal / length);
          mesh.texcoords()[vertex] = {static_cast<float>(section.fractions[i] * uv.repeat.x), v};
        }
      });
}

}  // namespace sweepkit::sweep
