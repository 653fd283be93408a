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
// place. Where the profile presses the section flat, sides along the pressed axis shrink to points: they are
// runs of columns of their own and have a pole each.

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
  glm::dvec3 across = point.tangent.x * row.x_direction + point.tangent.y * row.y_direction;
  if (across == glm::dvec3(0.0))  // pressed to a point, which leaves the direction
    across = point.tangent.x * side.frame.normal + point.tangent.y * side.frame.binormal;
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
      : mesh_(mesh),
        wall_(wall),
        spine_(spine),
        column_runs_(wall.column_runs),
        poles_(wall.column_runs.size(), spine.poles),
        v_scale_(uv.repeat.y) {
    find_pressed_sides();
    const std::vector<double>& fractions = wall.morph.keys.front().fractions;
    u_.reserve(fractions.size());
    for (const double fraction : fractions) u_.push_back(static_cast<float>(fraction * uv.repeat.x));
  }

  void write(glm::dvec2 period) {
    const auto first_vertex = static_cast<std::uint32_t>(mesh_.n_vertices());
    lay_out_wall(mesh_, column_runs_, spine_.runs, poles_, period);
    std::size_t table_run = column_runs_.size();  // whose points are in points_, of no row's own
    for_each_wall_row(first_vertex, column_runs_, spine_.runs, poles_,
                      [&](std::size_t vertex, std::size_t run, std::size_t row, std::size_t first,
                          std::size_t last, bool begins_run) {
                        const bool is_own = wall_.morph.changes() || is_home(row);
                        if (is_own || table_run != run) {
                          look_up(column_runs_[run], row);
                          table_run = is_own ? column_runs_.size() : run;
                        }
                        write_row(vertex, column_runs_[run].first, row, first, last, begins_run);
                      });
  }

 private:
  bool is_home(std::size_t row) const { return row + 1 == spine_.rows.size() && wall_.closing_columns > 0; }

  glm::vec3 vertex_at(const Row& row, const glm::dvec2& point) const {
    return {position_of(row, point) - mesh_.origin};
  }

  // Columns whose vertices are one place in a row that is pressed flat become runs with a pole there.
  void find_pressed_sides() {
    const std::size_t columns = wall_.morph.columns();
    std::vector<std::size_t> rows;
    std::vector<std::vector<bool>> is_shrunk;  // for every such row, a flag a cell
    for (std::size_t j = 0; j < spine_.rows.size(); ++j) {
      const Row& row = spine_.rows[j];
      if (!row.is_pressed) continue;
      look_up({0, columns}, j);
      rows.push_back(j);
      std::vector<bool>& flags = is_shrunk.emplace_back(columns);
      for (std::size_t i = 0; i < columns; ++i)
        flags[i] = vertex_at(row, points_[i].position) == vertex_at(row, points_[i + 1].position);
    }
    if (rows.empty()) return;
    std::vector<bool> splits(columns + 1, false);
    for (const Run& run : wall_.column_runs) splits[run.first] = true;
    for (const std::vector<bool>& flags : is_shrunk) {
      for (std::size_t i = 1; i < columns; ++i) splits[i] = splits[i] || flags[i - 1] != flags[i];
    }
    column_runs_ = split_runs(splits);
    poles_.assign(column_runs_.size(), spine_.poles);
    for (std::size_t run = 0; run < column_runs_.size(); ++run) {
      for (std::size_t k = 0; k < rows.size(); ++k)
        poles_[run][rows[k]] = is_shrunk[k][column_runs_[run].first];
    }
  }

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
  std::vector<Run> column_runs_;
  Poles poles_;
  double v_scale_;
  std::vector<float> u_;
  std::vector<RowPoint> points_;
};

}  // namespace

void add_wall(Mesh& mesh, const Wall& wall, const Spine& spine, const UvOptions& uv) {
  const glm::dvec2 period(wall.morph.keys.front().is_closed ? uv.repeat.x : 0,
                          spine.is_closed ? uv.repeat.y : 0);
  WallWriter(mesh, wall, spine, uv).write(period);
}

}  // namespace sweepkit::sweep
