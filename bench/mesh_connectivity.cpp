// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The connectivity of a million triangles: OpenMesh's own add_face() against indices written directly. Both
// start from the same vertices with room reserved for all edges and faces; each run is compared with the
// other's face by face.
//
// Usage: bench_mesh_connectivity [FILE.csv]

#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

#include "half_edges.hpp"
#include "harness.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace {

using namespace sweepkit;
using sweep::Mesh;

// 800 x 640 cells of two triangles.
constexpr sweep::Tessellation kCells{800, 640};

// The vertices and triangles of `source`, room for its edges, and no edge yet.
void start_over(Mesh& mesh, const Mesh& source) {
  mesh = Mesh();
  mesh.triangles = source.triangles;
  mesh.patches = source.patches;
  mesh.areas = source.areas;
  mesh.reserve(source.n_vertices(), source.n_edges(), source.n_faces());
  mesh.resize(source.n_vertices(), 0, 0);
}

void add_faces(Mesh& mesh) {
  const auto handle = [](std::uint32_t vertex) { return OpenMesh::VertexHandle(static_cast<int>(vertex)); };
  for (const sweep::Triangle& t : mesh.triangles) mesh.add_face(handle(t[0]), handle(t[1]), handle(t[2]));
}

// The half-edge of a face that ends at `vertex`.
OpenMesh::HalfedgeHandle half_edge_to(const Mesh& mesh, OpenMesh::FaceHandle face, std::uint32_t vertex) {
  OpenMesh::HalfedgeHandle half = mesh.halfedge_handle(face);
  for (int i = 0; i < 3; ++i, half = mesh.next_halfedge_handle(half)) {
    if (mesh.to_vertex_handle(half).idx() == static_cast<int>(vertex)) return half;
  }
  return OpenMesh::HalfedgeHandle();
}

// What two meshes differ in: corners, neighbours across each side, boundary, the way round each vertex. "" if
// in nothing.
std::string difference(const Mesh& a, const Mesh& b) {
  if (a.n_faces() != b.n_faces() || a.n_edges() != b.n_edges() || a.n_halfedges() != b.n_halfedges())
    return "another number of faces or edges";
  for (std::size_t f = 0; f < a.n_faces(); ++f) {
    const OpenMesh::FaceHandle face(static_cast<int>(f));
    for (const std::uint32_t corner : a.triangles[f]) {
      const OpenMesh::HalfedgeHandle in_a = half_edge_to(a, face, corner);
      const OpenMesh::HalfedgeHandle in_b = half_edge_to(b, face, corner);
      if (!in_a.is_valid() || !in_b.is_valid() || a.from_vertex_handle(in_a) != b.from_vertex_handle(in_b))
        return "other corners of face " + std::to_string(f);
      if (a.opposite_face_handle(in_a) != b.opposite_face_handle(in_b))
        return "another neighbour of face " + std::to_string(f);
    }
  }
  for (std::size_t h = 0; h < a.n_halfedges(); ++h) {
    const OpenMesh::HalfedgeHandle half(static_cast<int>(h));
    if (a.prev_halfedge_handle(a.next_halfedge_handle(half)) != half)
      return "half-edge " + std::to_string(h) + " whose next has another before it";
  }
  for (std::size_t v = 0; v < a.n_vertices(); ++v) {
    const OpenMesh::VertexHandle vertex(static_cast<int>(v));
    if (a.valence(vertex) != b.valence(vertex) || a.is_boundary(vertex) != b.is_boundary(vertex))
      return "other surroundings of vertex " + std::to_string(v);
  }
  return "";
}

int compare_ways(const char* csv_name) {
  const Mesh source =
      sweep::sweep(sweep::circle_contour(0.3), sweep::circle_trajectory(1), {.tessellation = kCells});
  Mesh reference;
  start_over(reference, source);
  add_faces(reference);

  Mesh added;
  Mesh direct;
  const bench::Comparison comparison =
      bench::compare("mesh_connectivity",
                     {{"add_face", [&] { add_faces(added); }, [&] { return difference(added, reference); },
                       [&] { start_over(added, source); }},
                      {"direct", [&] { sweep::write_half_edges(direct); },
                       [&] { return difference(direct, reference); }, [&] { start_over(direct, source); }}});
  std::fputs(bench::to_table(comparison).c_str(), stdout);
  const double faces = static_cast<double>(source.triangles.size());
  for (const bench::Result& result : comparison.results) {
    std::printf("  %-32s %10.1f M faces/s\n", result.name.c_str(), 1e-6 * faces / result.seconds.median);
  }
  if (csv_name != nullptr && !(std::ofstream(csv_name) << bench::to_csv({comparison}))) {
    std::fprintf(stderr, "%s: cannot be written\n", csv_name);
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return compare_ways(argc > 1 ? argv[1] : nullptr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
