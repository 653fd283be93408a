// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The general sweep of Akman and Arslan (1992), with rotation-minimizing frames:
//   S(s, t) = c(t) + x(s) X(t) + y(s) Y(t)
// and its normal from the derivatives, t measured by arc length. Away from mitres X = N and Y = B, and with
// the curvature vector dT/dt = kN N + kB B and the closing rate w (radians a metre about T)
//   X' = w B - kN T,   Y' = -w N - kB T,
//   dS/ds x dS/dt = a (y' N - x' B) + w (x x' + y y') T,   a = 1 - x kN - y kB.
// a < 0 where the contour reaches past the centre of curvature and the surface folds over; the normal keeps
// to the contour's outside there.
//
// At a corner of the trajectory the ring lies in the plane that halves it (a mitre): every point q of the
// section slides along T by g(q) = -(q.m)/(T.m), m the plane's normal. That is linear in (x, y), so it is
// folded into the row's own axes: X = N + g(N) T, Y = B + g(B) T. Along a straight piece g runs evenly from
// the mitre at one end to that at the other, so no ring of it crosses the mitre however close it stands.

#include "sweepkit/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "cap.hpp"
#include "grid_writer.hpp"
#include "half_edges.hpp"
#include "number_text.hpp"
#include "rotation_minimizing_frames.hpp"
#include "section.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

// A mitre longer than this many times the section's size is a reversal, not a corner.
constexpr double kLongestMitre = 1000;

// One side of a row: the frame there and how fast the row's axes change along the trajectory.
struct RowSide {
  Frame frame;
  glm::dvec3 x_rate{0.0};  // X', a metre
  glm::dvec3 y_rate{0.0};
};

struct Row {
  glm::dvec3 center;
  glm::dvec3 x_axis;  // S = center + x x_axis + y y_axis
  glm::dvec3 y_axis;
  RowSide in, out;
  bool is_corner = false;
};

glm::dvec2 curvature(const CurvePoint<3>& point, const Frame& frame) {
  const double speed_squared = glm::dot(point.first, point.first);
  // At a cusp the curvature is not finite; the section's own normal stands in.
  if (!(speed_squared > 0)) return glm::dvec2(0.0);
  const glm::dvec2 k =
      glm::dvec2(glm::dot(point.second, frame.normal), glm::dot(point.second, frame.binormal)) /
      speed_squared;
  return std::isfinite(k.x) && std::isfinite(k.y) ? k : glm::dvec2(0.0);
}

RowSide make_side(const Curve3& trajectory, CurveLocation location, const Frame& frame, double closing_rate) {
  const glm::dvec2 k = curvature(trajectory.evaluate(location), frame);
  return {frame, closing_rate * frame.binormal - k.x * frame.tangent,
          -closing_rate * frame.normal - k.y * frame.tangent};
}

// How far along T the section's axes slide onto a mitre plane: g for N and for B.
glm::dvec2 mitre_slide(const Frame& frame, const glm::dvec3& plane) {
  const double along = glm::dot(frame.tangent, plane);
  return glm::dvec2(-glm::dot(frame.normal, plane), -glm::dot(frame.binormal, plane)) / along;
}

bool is_straight(const Segment<3>& segment) {
  const auto* bezier = std::get_if<BezierSegment<3>>(&segment);
  return bezier != nullptr && bezier->control.size() == 2;
}

// Slides the sections between stations `first` and `last`, the ends of a smooth piece, evenly from the mitre
// at its start to that at its end. Only a straight piece is ruled, so only there the rings between the mitres
// move.
void slide_between(std::vector<Row>& rows, const std::vector<glm::dvec3>& planes, const Curve3& trajectory,
                   const std::vector<Station>& stations, double closing_rate, std::size_t first,
                   std::size_t last) {
  for (std::size_t segment = stations[first].out.segment; segment <= stations[last].in.segment; ++segment) {
    if (!is_straight(trajectory.segments()[segment])) return;
  }
  const double length = stations[last].length - stations[first].length;
  for (std::size_t i = first; i <= last; ++i) {
    Row& row = rows[i];
    RowSide& side = i == first ? row.out : row.in;
    const Frame& frame = side.frame;
    const glm::dvec2 none(0.0);
    const glm::dvec2 at_first = rows[first].is_corner ? mitre_slide(frame, planes[first]) : none;
    const glm::dvec2 at_last = rows[last].is_corner ? mitre_slide(frame, planes[last]) : none;
    const glm::dvec2 slide =
        glm::mix(at_first, at_last, (stations[i].length - stations[first].length) / length);
    if (i != first && i != last) {
      row.x_axis += slide.x * frame.tangent;
      row.y_axis += slide.y * frame.tangent;
    }
    // g changes along the piece, and with the directions of N and B as they turn by the closing rate.
    const glm::dvec2 rate = (at_last - at_first) / length + closing_rate * glm::dvec2(slide.y, -slide.x);
    side.x_rate += rate.x * frame.tangent;
    side.y_rate += rate.y * frame.tangent;
    if (i != first && i != last) row.out = row.in;
  }
}

std::vector<Row> make_rows(const Curve3& trajectory, const std::vector<Station>& stations,
                           const FramesAlong& along) {
  const std::size_t count = stations.size();
  std::vector<Row> rows(count);
  std::vector<glm::dvec3> planes(count, glm::dvec3(0.0));
  for (std::size_t i = 0; i < count; ++i) {
    Row& row = rows[i];
    row.center = trajectory.evaluate(stations[i].out).position;
    row.in = make_side(trajectory, stations[i].in, along.frames[i].in, along.closing_rate);
    row.out = make_side(trajectory, stations[i].out, along.frames[i].out, along.closing_rate);
    row.is_corner = stations[i].is_corner;
    if (!row.is_corner) {
      row.in = row.out;
      continue;
    }
    const glm::dvec3 bisector = row.in.frame.tangent + row.out.frame.tangent;
    if (!(glm::length(bisector) * kLongestMitre > 2)) {
      throw InputError("trajectory turns back on itself at " + number_text(stations[i].length) +
                       " m along it; a mitre there would be endless: round the corner off");
    }
    planes[i] = glm::normalize(bisector);
  }

  for (std::size_t i = 0; i < count; ++i) {
    Row& row = rows[i];
    const Frame& frame = row.in.frame;
    const glm::dvec2 slide = row.is_corner ? mitre_slide(frame, planes[i]) : glm::dvec2(0.0);
    row.x_axis = frame.normal + slide.x * frame.tangent;
    row.y_axis = frame.binormal + slide.y * frame.tangent;
  }
  std::size_t piece_start = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (!rows[i].is_corner && i + 1 < count) continue;
    slide_between(rows, planes, trajectory, stations, along.closing_rate, piece_start, i);
    piece_start = i;
  }
  if (trajectory.is_closed()) {
    // One place, the same bits.
    Row& first = rows.front();
    if (first.is_corner) {
      first.in = rows.back().in;
    } else {
      first.out = first.in;
    }
    rows.back() = first;
  }
  return rows;
}

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
  for (const Row& row : rows) {
    breaks.push_back(row.is_corner && glm::dot(row.in.frame.tangent, row.out.frame.tangent) < crease_cos);
  }
  return breaks;
}

void write_wall(Mesh& mesh, const Section& section, const std::vector<Row>& rows,
                const std::vector<double>& v_fractions, const std::vector<Run>& column_runs,
                const std::vector<Run>& row_runs, const std::vector<bool>& breaks, double closing_rate,
                const UvOptions& uv) {
  const std::span<glm::vec3> positions = mesh.positions();
  const std::span<glm::vec3> normals = mesh.normals();
  const std::span<glm::vec2> texcoords = mesh.texcoords();
  std::size_t vertex = mesh.patches.front().first_vertex;
  for (const Run& row_run : row_runs) {
    for (const Run& column_run : column_runs) {
      for (std::size_t j = row_run.first; j <= row_run.last; ++j) {
        const Row& row = rows[j];
        // A corner that breaks shows the side this run lies on; one that does not shows the middle of both.
        const bool is_middle = row.is_corner && !breaks[j];
        const RowSide& side = j == row_run.first && breaks[j] ? row.out : row.in;
        const auto v = static_cast<float>(v_fractions[j] * uv.repeat.y);
        for (std::size_t i = column_run.first; i <= column_run.last; ++i, ++vertex) {
          const SectionPoint& point = section.points[i];
          const glm::dvec2& tangent = i == column_run.first ? point.tangent_out : point.tangent_in;
          glm::dvec3 normal = normal_of(row, side, closing_rate, point.position, tangent);
          if (is_middle)
            normal = glm::normalize(normal + normal_of(row, row.out, closing_rate, point.position, tangent));
          positions[vertex] = glm::vec3(point_of(row, point.position) - mesh.origin);
          normals[vertex] = glm::vec3(normal);
          texcoords[vertex] = {static_cast<float>(section.fractions[i] * uv.repeat.x), v};
        }
      }
    }
  }
}

void add_cap(Mesh& mesh, const Section& section, const Row& row, bool is_first) {
  std::vector<glm::dvec2> outline;
  for (std::size_t i = 0; i + 1 < section.points.size(); ++i) outline.push_back(section.points[i].position);
  glm::dvec2 low = outline.front();
  glm::dvec2 high = low;
  for (const glm::dvec2& p : outline) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double size = std::max(high.x - low.x, high.y - low.y);
  const std::uint32_t first = add_vertices(mesh, outline.size());
  const glm::vec3 normal(is_first ? -row.out.frame.tangent : row.in.frame.tangent);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    mesh.positions()[first + i] = glm::vec3(point_of(row, outline[i]) - mesh.origin);
    mesh.normals()[first + i] = normal;
    // Seen from outside the first cap shows the contour mirrored; its u runs the other way so that no texture
    // does.
    const double u = (is_first ? high.x - outline[i].x : outline[i].x - low.x) / size;
    mesh.texcoords()[first + i] = {static_cast<float>(u), static_cast<float>((outline[i].y - low.y) / size)};
  }
  Area area;
  area.first_triangle = static_cast<std::uint32_t>(mesh.triangles.size());
  for (const Triangle& t : triangulate_polygon(outline)) {
    mesh.triangles.push_back(is_first ? Triangle{first + t[0], first + t[2], first + t[1]}
                                      : Triangle{first + t[0], first + t[1], first + t[2]});
  }
  area.triangle_count = static_cast<std::uint32_t>(mesh.triangles.size()) - area.first_triangle;
  mesh.areas.push_back(area);
}

}  // namespace

Mesh sweep(const Curve2& contour, const Curve3& trajectory, const SweepOptions& options) {
  check_cells(options.tessellation.contour, "contour");
  check_cells(options.tessellation.trajectory, "trajectory");
  check_texture(options.uv);
  const Section section =
      make_section(contour, options.tessellation.contour, options.crease_deg, options.uv.by);
  const std::vector<Station> stations = place_stations(trajectory, options.tessellation.trajectory);
  if (trajectory.is_closed()) check_loop(stations.size() - 1, "trajectory");
  const FramesAlong along = rotation_minimizing_frames(trajectory, stations);
  const std::vector<Row> rows = make_rows(trajectory, stations, along);
  const std::vector<bool> breaks = row_breaks(rows, options.crease_deg);

  glm::dvec3 low = point_of(rows.front(), section.points.front().position);
  glm::dvec3 high = low;
  double reach = 0;
  for (const SectionPoint& point : section.points) reach = std::max(reach, glm::length(point.position));
  for (const Row& row : rows) {
    low = glm::min(low, row.center - reach);
    high = glm::max(high, row.center + reach);
  }

  Mesh mesh;
  mesh.origin = choose_origin(low, high);
  const std::vector<Run> column_runs = split_runs(section.breaks);
  const std::vector<Run> row_runs = split_runs(breaks);
  const glm::dvec2 period(section.is_closed ? options.uv.repeat.x : 0,
                          trajectory.is_closed() ? options.uv.repeat.y : 0);
  lay_out_wall(mesh, column_runs, row_runs, std::vector<bool>(rows.size(), false), period);
  write_wall(mesh, section, rows, texture_fractions(stations, options.uv.by), column_runs, row_runs, breaks,
             along.closing_rate, options.uv);
  if (options.caps == Caps::kFlat && section.is_closed && !trajectory.is_closed()) {
    add_cap(mesh, section, rows.front(), true);
    add_cap(mesh, section, rows.back(), false);
  }
  if (options.has_half_edges) write_half_edges(mesh);
  return mesh;
}

}  // namespace sweepkit::sweep
