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

// What a vertex of a row needs of the section; `rate` is the morph's, a metre.
struct RowPoint {
  glm::dvec2 position;
  glm::dvec2 tangent;
  glm::dvec2 rate;
};

glm::dvec3 plain_normal(const Frame& frame, const glm::dvec2& tangent) {
  return tangent.y * frame.normal - tangent.x * frame.binormal;
}

glm::dvec3 normal_of(const Row& row, const RowSide& side, const RowPoint& point, bool is_plain) {
  // Where only the trajectory bends, both derivatives lie in planes that this is perpendicular to.
  if (is_plain) return plain_normal(side.frame, point.tangent);
  const glm::dvec3 across = point.tangent.x * row.x_direction + point.tangent.y * row.y_direction;
  const glm::dvec3 ahead = side.frame.tangent + point.position.x * side.x_rate +
                           point.position.y * side.y_rate + point.rate.x * row.x_axis +
                           point.rate.y * row.y_axis;
  const glm::dvec3 outward = glm::cross(across, side.frame.tangent);
  const glm::dvec3 normal = glm::cross(across, ahead);
  const double length = glm::length(normal);
  if (length > 1e-12 * glm::length(ahead) * glm::length(across)) {
    return (glm::dot(normal, outward) < 0 ? -normal : normal) / length;
  }
  const double width = glm::length(outward);
  return width > 0 ? outward / width : glm::normalize(plain_normal(side.frame, point.tangent));
}

class WallWriter {
 public:
  WallWriter(Mesh& mesh, const Wall& wall, const Spine& spine, const UvOptions& uv)
      : mesh_(mesh), wall_(wall), spine_(spine), v_scale_(uv.repeat.y) {
    const std::vector<double>& fractions = wall.morph.keys.front().fractions;
    u_.reserve(fractions.size());
    for (const double fraction : fractions) u_.push_back(static_cast<float>(fraction * uv.repeat.x));
  }

  void write(std::uint32_t first_vertex) {
    std::size_t table_run = wall_.column_runs.size();  // whose points are in points_, of no row's own
    for_each_wall_row(first_vertex, wall_.column_runs, spine_.runs, spine_.poles,
                      [&](std::size_t vertex, std::size_t run, std::size_t row, std::size_t first,
                          std::size_t last, bool begins_run) {
                        const bool is_own = wall_.morph.changes() || is_home(row);
                        if (is_own || table_run != run) {
                          look_up(wall_.column_runs[run], row);
                          table_run = is_own ? wall_.column_runs.size() : run;
                        }
                        write_row(vertex, wall_.column_runs[run].first, row, first, last, begins_run);
                      });
  }

 private:
  bool is_home(std::size_t row) const { return row + 1 == spine_.rows.size() && wall_.closing_columns > 0; }

  // The points of a run of columns, as they are in this row.
  void look_up(const Run& columns, std::size_t row) {
    const Morph& morph = wall_.morph;
    const KeyWeights weights = key_weights(morph, spine_.shares[row]);
    const std::size_t turned = is_home(row) ? wall_.closing_columns : 0;
    points_.clear();
    for (std::size_t i = columns.first; i <= columns.last; ++i) {
      const std::size_t column = turned > 0 ? (i + turned) % morph.columns() : i;
      const MorphPoint point = point_at(morph, weights, column, i == columns.first);
      points_.push_back({point.position, point.tangent, point.rate / spine_.length});
    }
  }

  void write_row(std::size_t vertex, std::size_t run_first, std::size_t j, std::size_t first,
                 std::size_t last, bool begins_run) {
    const Row& row = spine_.rows[j];
    // A corner that breaks shows the side this run lies on; one that does not shows the middle of both.
    const RowSide& side = begins_run && spine_.breaks[j] ? row.out : row.in;
    const bool has_two_sides = row.is_corner && !spine_.breaks[j];
    const bool changes = wall_.morph.changes();
    const bool is_plain = side.is_plain && !changes;
    const bool is_out_plain = row.out.is_plain && !changes;
    const auto v = static_cast<float>(spine_.v[j] * v_scale_);
    glm::vec3* positions = &mesh_.positions()[vertex];
    glm::vec3* normals = &mesh_.normals()[vertex];
    glm::vec2* texcoords = &mesh_.texcoords()[vertex];
    const RowPoint* point = &points_[first - run_first];
    const std::size_t count = last - first + 1;
    const glm::dvec3 origin = mesh_.origin;
    // Loops of one thing each, which the compiler keeps in registers.
    for (std::size_t i = 0; i < count; ++i)
      positions[i] = glm::vec3(position_of(row, point[i].position) - origin);
    if (is_plain && !has_two_sides) {
      const Frame frame = side.frame;
      for (std::size_t i = 0; i < count; ++i) normals[i] = glm::vec3(plain_normal(frame, point[i].tangent));
    } else {
      for (std::size_t i = 0; i < count; ++i) {
        glm::dvec3 normal = normal_of(row, side, point[i], is_plain);
        if (has_two_sides) normal = glm::normalize(normal + normal_of(row, row.out, point[i], is_out_plain));
        normals[i] = glm::vec3(normal);
      }
    }
    for (std::size_t i = 0; i < count; ++i) texcoords[i] = {u_[first + i], v};
  }

  Mesh& mesh_;
  const Wall& wall_;
  const Spine& spine_;
  double v_scale_;
  std::vector<float> u_;
  std::vector<RowPoint> points_;
};

}  // namespace

void add_wall(Mesh& mesh, const Wall& wall, const Spine& spine, const UvOptions& uv) {
  const auto first = static_cast<std::uint32_t>(mesh.n_vertices());
  const glm::dvec2 period(wall.morph.keys.front().is_closed ? uv.repeat.x : 0,
                          spine.is_closed ? uv.repeat.y : 0);
  lay_out_wall(mesh, wall.column_runs, spine.runs, spine.poles, period);
  WallWriter(mesh, wall, spine, uv).write(first);
}

}  // namespace sweepkit::sweep
