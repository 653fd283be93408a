// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// OpenMesh's connectivity written in place. add_face() searches for every edge it is given; on a grid each
// index is known beforehand. Half-edge 2e runs along edge e, 2e + 1 against it. A patch of C x R cells has
// the edges
//   H(i, j)  vertex (i, j) -> (i+1, j)     V(i, j)  (i, j) -> (i, j+1)     D(i, j)  (i+1, j) -> (i, j+1), the
//   diagonal
// A pole row has no H, and lacks one V as it lacks one vertex (GridPatch says which).

#include "half_edges.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "directed_edges.hpp"
#include "first_touch.hpp"

namespace sweepkit::sweep {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

struct PatchEdges {
  const GridPatch& patch;
  std::uint32_t first_edge;

  std::uint32_t h_rows() const {
    return patch.rows + 1 - (patch.has_first_pole ? 1u : 0u) - (patch.has_last_pole ? 1u : 0u);
  }
  std::uint32_t h(std::uint32_t i, std::uint32_t j) const {
    return first_edge + (j - (patch.has_first_pole ? 1u : 0u)) * patch.columns + i;
  }
  std::uint32_t v(std::uint32_t i, std::uint32_t j) const {
    return first_edge + h_rows() * patch.columns + j * (patch.columns + 1) + i -
           (patch.has_first_pole ? 1u : 0u);
  }
  std::uint32_t d(std::uint32_t i, std::uint32_t j) const {
    return first_edge + count() - patch.rows * patch.columns + j * patch.columns + i;
  }
  std::uint32_t count() const {
    return h_rows() * patch.columns + patch.rows * (patch.columns + 1) - (patch.has_first_pole ? 1u : 0u) -
           (patch.has_last_pole ? 1u : 0u) + patch.rows * patch.columns;
  }
};

class Writer {
 public:
  explicit Writer(Mesh& mesh) : mesh_(mesh) {}

  void edge(std::uint32_t edge, std::uint32_t from, std::uint32_t to) {
    mesh_.set_vertex_handle(half(2 * edge), VertexHandle(static_cast<int>(to)));
    mesh_.set_vertex_handle(half(2 * edge + 1), VertexHandle(static_cast<int>(from)));
  }

  void face(std::uint32_t face, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const FaceHandle handle(static_cast<int>(face));
    mesh_.set_next_halfedge_handle(half(a), half(b));
    mesh_.set_next_halfedge_handle(half(b), half(c));
    mesh_.set_next_halfedge_handle(half(c), half(a));
    mesh_.set_face_handle(half(a), handle);
    mesh_.set_face_handle(half(b), handle);
    mesh_.set_face_handle(half(c), handle);
    mesh_.set_halfedge_handle(handle, half(a));
  }

  void outgoing(std::uint32_t vertex, std::uint32_t half_edge) {
    mesh_.set_halfedge_handle(VertexHandle(static_cast<int>(vertex)), half(half_edge));
  }

  // A loop of boundary half-edges in order. Each of its vertices keeps a boundary half-edge as its outgoing
  // one, as OpenMesh asks.
  void boundary(const std::vector<std::uint32_t>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const HalfedgeHandle here = half(loop[i]);
      mesh_.set_boundary(here);
      mesh_.set_next_halfedge_handle(here, half(loop[(i + 1) % loop.size()]));
      mesh_.set_halfedge_handle(mesh_.from_vertex_handle(here), here);
    }
  }

 private:
  static HalfedgeHandle half(std::uint32_t index) { return HalfedgeHandle(static_cast<int>(index)); }

  Mesh& mesh_;
};

void write_patch(Writer& writer, const GridPatch& patch, std::uint32_t first_edge) {
  const PatchEdges edges{patch, first_edge};
  const std::uint32_t columns = patch.columns;
  const std::uint32_t rows = patch.rows;
  std::uint32_t face = patch.first_triangle;
  for (std::uint32_t j = 0; j <= rows; ++j) {
    const bool is_pole = (patch.has_first_pole && j == 0) || (patch.has_last_pole && j == rows);
    for (std::uint32_t i = 0; i < columns && !is_pole; ++i) {
      writer.edge(edges.h(i, j), patch.vertex(i, j), patch.vertex(i + 1, j));
      writer.outgoing(patch.vertex(i, j), 2 * edges.h(i, j));
    }
  }
  for (std::uint32_t j = 0; j < rows; ++j) {
    const bool has_lower = !(patch.has_first_pole && j == 0);
    const bool has_upper = !(patch.has_last_pole && j + 1 == rows);
    for (std::uint32_t i = has_lower ? 0 : 1; i <= (has_upper ? columns : columns - 1); ++i) {
      writer.edge(edges.v(i, j), patch.vertex(i, j), patch.vertex(i, j + 1));
    }
    for (std::uint32_t i = 0; i < columns; ++i) {
      writer.edge(edges.d(i, j), patch.vertex(i + 1, j), patch.vertex(i, j + 1));
      if (has_lower) writer.face(face++, 2 * edges.v(i, j) + 1, 2 * edges.h(i, j), 2 * edges.d(i, j));
      if (has_upper)
        writer.face(face++, 2 * edges.v(i + 1, j), 2 * edges.h(i, j + 1) + 1, 2 * edges.d(i, j) + 1);
    }
  }

  // Clockwise: up the left side, along the last row, down the right side, back along the first row.
  std::vector<std::uint32_t> loop;
  const std::uint32_t left_first = patch.has_first_pole ? 1 : 0;
  const std::uint32_t right_end = patch.has_last_pole ? rows - 1 : rows;
  for (std::uint32_t j = left_first; j < rows; ++j) loop.push_back(2 * edges.v(0, j));
  for (std::uint32_t i = 0; i < columns; ++i) {
    if (!patch.has_last_pole) {
      loop.push_back(2 * edges.h(i, rows));
    } else {  // to the column's pole by V, back down by the diagonal
      if (i > 0) loop.push_back(2 * edges.v(i, rows - 1));
      loop.push_back(2 * edges.d(i, rows - 1) + 1);
    }
  }
  for (std::uint32_t j = right_end; j-- > 0;) loop.push_back(2 * edges.v(columns, j) + 1);
  for (std::uint32_t i = columns; i-- > 0;) {
    if (!patch.has_first_pole) {
      loop.push_back(2 * edges.h(i, 0) + 1);
    } else {
      if (i + 1 < columns) loop.push_back(2 * edges.v(i + 1, 0) + 1);
      loop.push_back(2 * edges.d(i, 0));
    }
  }
  writer.boundary(loop);
}

// Two triangles share an edge; what a third one has there, in a cap whose outlines cross, is one of its own.
std::uint32_t count_edges(std::span<const DirectedEdge> edges) {
  std::uint32_t count = 0;
  for_each_edge(edges, [&](const DirectedEdge&, const DirectedEdge*) { ++count; });
  return count;
}

void write_disc(Writer& writer, const Mesh& mesh, std::span<const DirectedEdge> edges,
                std::uint32_t first_triangle, std::uint32_t first_edge) {
  std::vector<std::array<std::uint32_t, 3>> halves(edges.size() / 3);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open;  // (from vertex, half-edge) of the boundary
  std::uint32_t edge = first_edge;
  for_each_edge(edges, [&](const DirectedEdge& one, const DirectedEdge* twin) {
    writer.edge(edge, one.low, one.high);
    for (const DirectedEdge* side : {&one, twin}) {
      if (side == nullptr) continue;
      const std::uint32_t from = side->is_upward ? side->low : side->high;
      const std::uint32_t half_edge = 2 * edge + (side->is_upward ? 0u : 1u);
      halves[side->triangle - first_triangle][side->corner] = half_edge;
      writer.outgoing(from, half_edge);
      if (twin == nullptr) open.push_back({from == one.low ? one.high : one.low, half_edge ^ 1u});
    }
    ++edge;
  });
  for (std::uint32_t t = 0; t < halves.size(); ++t)
    writer.face(first_triangle + t, halves[t][0], halves[t][1], halves[t][2]);

  // A loop for the outline and one for each hole: from each vertex an open half-edge leads on.
  std::sort(open.begin(), open.end());
  std::vector<bool> is_used(open.size(), false);
  std::vector<std::uint32_t> loop;
  for (std::size_t i = 0; i < open.size(); ++i) {
    loop.clear();
    std::size_t next = i;
    while (next < open.size() && !is_used[next]) {
      is_used[next] = true;
      loop.push_back(open[next].second);
      const OpenMesh::HalfedgeHandle half(static_cast<int>(open[next].second));
      const auto vertex = static_cast<std::uint32_t>(mesh.to_vertex_handle(half).idx());
      next = static_cast<std::size_t>(std::lower_bound(open.begin(), open.end(), std::pair{vertex, 0u}) -
                                      open.begin());
      // Where loops touch, more than one leads on.
      while (next < open.size() && open[next].first == vertex && is_used[next]) ++next;
      if (next < open.size() && open[next].first != vertex) break;
    }
    if (!loop.empty()) writer.boundary(loop);
  }
}

}  // namespace

void write_half_edges(Mesh& mesh) {
  std::vector<std::uint32_t> first_edges;
  std::uint32_t edge_count = 0;
  for (const GridPatch& patch : mesh.patches) {
    first_edges.push_back(edge_count);
    edge_count += PatchEdges{patch, 0}.count();
  }
  std::vector<std::vector<DirectedEdge>> discs;
  std::vector<std::uint32_t> disc_triangles;
  for (std::uint32_t index = 0; index < mesh.areas.size(); ++index) {
    const bool is_wall = std::any_of(mesh.patches.begin(), mesh.patches.end(),
                                     [&](const GridPatch& patch) { return patch.area == index; });
    const Area& area = mesh.areas[index];
    if (is_wall || area.triangle_count == 0) continue;
    discs.push_back(
        sorted_edges(mesh.triangles, area.first_triangle, area.first_triangle + area.triangle_count));
    disc_triangles.push_back(area.first_triangle);
    first_edges.push_back(edge_count);
    edge_count += count_edges(discs.back());
  }

  if (mesh.n_edges() == 0 && edge_count > 0 && !mesh.triangles.empty()) {
    // As add_vertices() does.
    mesh.reserve(mesh.n_vertices(), edge_count, mesh.triangles.size());
    mesh.resize(mesh.n_vertices(), 1, 1);
    prepare_first_touch(&mesh.edge(OpenMesh::EdgeHandle(0)), edge_count * sizeof(Mesh::Edge));
    prepare_first_touch(&mesh.face(FaceHandle(0)), mesh.triangles.size() * sizeof(Mesh::Face));
  }
  mesh.resize(mesh.n_vertices(), edge_count, mesh.triangles.size());
  Writer writer(mesh);
  for (std::size_t i = 0; i < mesh.patches.size(); ++i) write_patch(writer, mesh.patches[i], first_edges[i]);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    write_disc(writer, mesh, discs[i], disc_triangles[i], first_edges[mesh.patches.size() + i]);
  }
}

}  // namespace sweepkit::sweep
