// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The general sweep of Akman and Arslan (1992), profiled, twisted and morphed:
//   S(s, t) = c(t) + x(s, t) X(t) + y(s, t) Y(t)
// and its normal from the derivatives, t measured by arc length (rows.cpp says what X and Y are, morph.cpp
// how x and y change). Away from mitres, profile, twist and morph that is
//   dS/ds x dS/dt = a (y' N - x' B),   a = 1 - x kN - y kB,
// kN and kB the curvature. a < 0 where the contour reaches past the centre of curvature and the surface folds
// over; the normal keeps to the contour's outside there. At a pole dS/ds is 0 and its direction takes its
// place.

#include "wall.hpp"

namespace sweepkit::sweep {
namespace {

// `rate` is the morph's, a metre.
glm::dvec3 normal_of(const Row& row, const RowSide& side, const MorphPoint& point, const glm::dvec2& rate,
                     bool changes) {
  const Frame& f = side.frame;
  const glm::dvec2& tangent = point.tangent;
  // Where only the trajectory bends, both derivatives lie in planes that this is perpendicular to.
  if (side.is_plain && !changes) return tangent.y * f.normal - tangent.x * f.binormal;
  const glm::dvec3 across = tangent.x * row.x_direction + tangent.y * row.y_direction;
  const glm::dvec3 ahead = f.tangent + point.position.x * side.x_rate + point.position.y * side.y_rate +
                           rate.x * row.x_axis + rate.y * row.y_axis;
  const glm::dvec3 outward = glm::cross(across, f.tangent);
  const glm::dvec3 normal = glm::cross(across, ahead);
  const double length = glm::length(normal);
  if (length > 1e-12 * glm::length(ahead) * glm::length(across)) {
    return (glm::dot(normal, outward) < 0 ? -normal : normal) / length;
  }
  const double width = glm::length(outward);
  return width > 0 ? outward / width : glm::normalize(tangent.y * f.normal - tangent.x * f.binormal);
}

void write_vertices(Mesh& mesh, std::uint32_t first, const Wall& wall, const Spine& spine,
                    const UvOptions& uv) {
  const std::span<glm::vec3> positions = mesh.positions();
  const std::span<glm::vec3> normals = mesh.normals();
  const std::span<glm::vec2> texcoords = mesh.texcoords();
  const Morph& morph = wall.morph;
  const std::size_t columns = morph.columns();
  const std::vector<double>& u = morph.keys.front().fractions;
  std::vector<KeyWeights> weights;
  if (morph.changes()) {
    weights.reserve(spine.rows.size());
    for (const double share : spine.shares) weights.push_back(key_weights(morph, share));
  }
  for_each_wall_vertex(
      first, wall.column_runs, spine.runs, spine.poles,
      [&](std::size_t vertex, std::size_t i, std::size_t j, const Run& column_run, const Run& row_run) {
        const Row& row = spine.rows[j];
        const bool is_home = j + 1 == spine.rows.size() && wall.closing_columns > 0;
        const MorphPoint point =
            point_at(morph, morph.changes() ? weights[j] : KeyWeights{},
                     is_home ? (i + wall.closing_columns) % columns : i, i == column_run.first);
        const glm::dvec2 rate = point.rate / spine.length;
        // A corner that breaks shows the side this run lies on; one that does not shows the middle of both.
        const RowSide& side = j == row_run.first && spine.breaks[j] ? row.out : row.in;
        glm::dvec3 normal = normal_of(row, side, point, rate, morph.changes());
        if (row.is_corner && !spine.breaks[j])
          normal = glm::normalize(normal + normal_of(row, row.out, point, rate, morph.changes()));
        positions[vertex] = glm::vec3(position_of(row, point.position) - mesh.origin);
        normals[vertex] = glm::vec3(normal);
        texcoords[vertex] = {static_cast<float>(u[i] * uv.repeat.x),
                             static_cast<float>(spine.v[j] * uv.repeat.y)};
      });
}

}  // namespace

void add_wall(Mesh& mesh, const Wall& wall, const Spine& spine, const UvOptions& uv) {
  const auto first = static_cast<std::uint32_t>(mesh.n_vertices());
  const glm::dvec2 period(wall.morph.keys.front().is_closed ? uv.repeat.x : 0,
                          spine.is_closed ? uv.repeat.y : 0);
  lay_out_wall(mesh, wall.column_runs, spine.runs, spine.poles, period);
  write_vertices(mesh, first, wall, spine, uv);
}

}  // namespace sweepkit::sweep
