// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace sweepkit::sweep {

/// Vertices (A, B, C), counter-clockwise seen from outside. On a grid patch B is the corner that the
/// texture's right triangle has its right angle at, A lies along v from it and C along u (the letters of the
/// paper's Fig. 2).
using Triangle = std::array<std::uint32_t, 3>;

/// A rectangular stretch of a mesh: columns x rows cells along u and v, two triangles a cell, first those of
/// row 0. Cell (i, j) has the corners p = vertex(i, j), q = vertex(i+1, j), r = vertex(i, j+1), s =
/// vertex(i+1, j+1) and the triangles (r, p, q) and (q, s, r). A pole row holds one vertex a column, each
/// with the u of its triangle's right angle, and its cells one triangle: (q, s, r) at the first row, (r, p,
/// q) at the last. A mirrored copy (append() with a placement that mirrors) has A and C of every triangle
/// exchanged: (q, p, r) and (r, s, q).
struct GridPatch {
  std::uint32_t first_vertex = 0;
  std::uint32_t first_triangle = 0;
  std::uint32_t columns = 0;  ///< cells along u; a row of vertices has columns + 1
  std::uint32_t rows = 0;     ///< cells along v
  bool has_first_pole = false;
  bool has_last_pole = false;
  std::uint32_t area = 0;  ///< index into the mesh's areas

  std::uint32_t vertex(std::uint32_t column, std::uint32_t row) const {
    // The first pole row leaves out column 0, the last one column `columns`.
    const std::uint32_t skipped = has_first_pole ? 1u : 0u;
    return first_vertex + row * (columns + 1) + column - skipped;
  }
  std::uint32_t vertex_count() const {
    return (columns + 1) * (rows + 1) - (has_first_pole ? 1u : 0u) - (has_last_pole ? 1u : 0u);
  }
  std::uint32_t triangle_count() const {
    return columns * (2 * rows - (has_first_pole ? 1u : 0u) - (has_last_pole ? 1u : 0u));
  }
  std::uint32_t first_triangle_of_row(std::uint32_t row) const {
    return first_triangle + columns * (2 * row - (has_first_pole && row > 0 ? 1u : 0u));
  }
};

/// A stretch of triangles that is one piece of texture: neighbouring (u,v) inside it are neighbours on the
/// surface. A sweep's wall is one area even where creases split it into several grid patches; each cap is
/// another.
struct Area {
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
  double u_period = 0;  ///< u comes round after this much (closed contour, whole turn); 0 if it does not
  double v_period = 0;
  /// Lies on the same sheet of texture as the area before it: the two do not overlap in (u,v).
  bool continues_sheet = false;
};

}  // namespace sweepkit::sweep
