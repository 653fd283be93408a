// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "half_edges.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "mesh_measures.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep {
namespace {

using Edge = std::pair<int, int>;

// The same connectivity made by OpenMesh itself.
Mesh added_face_by_face(const Mesh& mesh) {
  Mesh added;
  for (const glm::vec3& p : mesh.positions()) added.add_vertex({p.x, p.y, p.z});
  for (const Triangle& t : mesh.triangles) {
    added.add_face(OpenMesh::VertexHandle(static_cast<int>(t[0])),
                   OpenMesh::VertexHandle(static_cast<int>(t[1])),
                   OpenMesh::VertexHandle(static_cast<int>(t[2])));
  }
  return added;
}

std::set<Edge> boundary_edges(const Mesh& mesh) {
  std::set<Edge> edges;
  for (const auto h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) edges.insert({mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx()});
  }
  return edges;
}

// What OpenMesh's own add_face() makes, this is in everything a user can walk.
void expect_same_connectivity(const Mesh& mesh) {
  const Mesh added = added_face_by_face(mesh);
  ASSERT_EQ(mesh.n_faces(), added.n_faces());
  ASSERT_EQ(mesh.n_edges(), added.n_edges());
  ASSERT_EQ(mesh.n_vertices(), added.n_vertices());
  for (const auto f : mesh.faces()) {
    std::set<int> corners;
    for (const auto v : mesh.fv_range(f)) corners.insert(v.idx());
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(f.idx())];
    EXPECT_EQ(corners,
              (std::set<int>{static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])}));
  }
  for (const auto h : mesh.halfedges()) {
    const auto next = mesh.next_halfedge_handle(h);
    ASSERT_EQ(mesh.prev_halfedge_handle(next), h);
    ASSERT_EQ(mesh.from_vertex_handle(next), mesh.to_vertex_handle(h));
    ASSERT_EQ(mesh.face_handle(next), mesh.face_handle(h));
  }
  for (const auto v : mesh.vertices()) {
    ASSERT_EQ(mesh.valence(v), added.valence(v));
    ASSERT_EQ(mesh.is_boundary(v), added.is_boundary(v));
    ASSERT_EQ(mesh.from_vertex_handle(mesh.halfedge_handle(v)), v);
    std::set<int> around;
    std::set<int> around_added;
    for (const auto w : mesh.vv_range(v)) around.insert(w.idx());
    for (const auto w : added.vv_range(v)) around_added.insert(w.idx());
    ASSERT_EQ(around, around_added);
    // A boundary vertex must store a boundary half-edge, or OpenMesh's circulators start in the wrong place.
    ASSERT_EQ(mesh.is_boundary(mesh.halfedge_handle(v)), mesh.is_boundary(v));
  }
  EXPECT_EQ(boundary_edges(mesh), boundary_edges(added));
}

Curve2 half_circle() {
  return Curve2({ArcSegment<2>{{0, 0}, {1, 0}, {0, 1}, -90, 90}});
}

TEST(HalfEdges, EqualAddFaceOnPlainGrids) {
  for (const auto& [columns, rows] : {std::pair{1, 1}, std::pair{1, 4}, std::pair{5, 1}, std::pair{7, 3}}) {
    expect_same_connectivity(plane({1, 1}, {.tessellation = {columns, rows}}));
  }
}

TEST(HalfEdges, EqualAddFaceWithPolesAtEitherEndAndBoth) {
  expect_same_connectivity(revolve(half_circle(), {.tessellation = {2, 3}}));
  expect_same_connectivity(revolve(half_circle(), {.tessellation = {8, 12}}));
  expect_same_connectivity(revolve(polyline<2>({{0, 0}, {1, 1}}, false), {.tessellation = {1, 5}}));
  expect_same_connectivity(revolve(polyline<2>({{0, 0}, {1, 1}}, false), {.tessellation = {4, 5}}));
  expect_same_connectivity(revolve(polyline<2>({{1, 0}, {0, 1}}, false), {.tessellation = {1, 5}}));
  expect_same_connectivity(revolve(polyline<2>({{1, 0}, {0, 1}}, false), {.tessellation = {4, 5}}));
}

TEST(HalfEdges, EqualAddFaceWithCreasesCapsAndConcaveCaps) {
  const Curve2 arrow = polyline<2>({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}}, true);
  expect_same_connectivity(
      sweep(arrow, polyline<3>({{0, 0, 0}, {0, 3, 0}, {2, 4, 0}}, false), {.tessellation = {20, 6}}));
  expect_same_connectivity(
      sweep(circle_contour(1), polyline<3>({{0, 0, 0}, {0, 0, 1}}, false), {.tessellation = {9, 2}}));
  expect_same_connectivity(sweep(circle_contour(0.2), circle_trajectory(1), {.tessellation = {9, 20}}));
}

TEST(HalfEdges, EqualAddFaceWithPolesOfSingleRunsOfColumns) {
  const Law falling = Law::bezier({{0, 1}, {1, 0}});
  const Law waist = Law::through({{0, 1}, {0.5, 0}, {1, 1}});
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
  for (const Law& law : {falling, waist}) {
    expect_same_connectivity(
        sweep(rectangle_contour(0.25, 0.5), line, {.tessellation = {24, 4}, .profile = {law, 1}}));
    expect_same_connectivity(
        sweep(rectangle_contour(0.25, 0.5, 0.0625), line, {.tessellation = {24, 1}, .profile = {1, law}}));
  }
}

TEST(HalfEdges, AreLeftOutOnRequestAndCostNothing) {
  const Mesh mesh =
      sweep(circle_contour(0.2), circle_trajectory(1), {.tessellation = {9, 20}, .has_half_edges = false});
  EXPECT_EQ(mesh.n_faces(), 0u);
  EXPECT_EQ(mesh.n_edges(), 0u);
  EXPECT_EQ(mesh.half_edge_bytes(), 0u);
  EXPECT_EQ(mesh.triangles.size(), 360u);
}

TEST(HalfEdges, SurviveAppendingPartsMirroredOrNot) {
  for (const double sign : {1.0, -1.0}) {
    Mesh whole;
    glm::dmat4 placement(1.0);
    placement[0][0] = sign;
    placement[3] = glm::dvec4(3, 0, 0, 1);
    append(whole, revolve(half_circle(), {.tessellation = {6, 8}}), glm::dmat4(1.0));
    append(whole, sweep(circle_contour(0.2), circle_trajectory(1), {.tessellation = {5, 7}}), placement);
    append(whole, plane({1, 1}, {.tessellation = {2, 3}}), placement);
    expect_same_connectivity(whole);
    EXPECT_EQ(whole.areas.size(), 3u);
    EXPECT_EQ(whole.patches.size(), 3u);
  }
}

// Holes in rows and columns: their corners lie at the same heights, so every bridge to one meets others.
TEST(HalfEdges, OfCapsWithRowsOfHolesAreThoseOfAddFace) {
  std::vector<Curve2> outlines = {polyline<2>({{0, 0}, {13, 0}, {13, 10}, {0, 10}}, true)};
  double holes = 0;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 3; ++y) {
      const glm::dvec2 low(1 + 3 * x, 1 + 3 * y);
      outlines.push_back(
          polyline<2>({low, low + glm::dvec2(2, 0), low + glm::dvec2(2, 2), low + glm::dvec2(0, 2)}, true));
      holes += 4;
    }
  }
  for (const int cells : {52, 64, 100, 317}) {
    const Mesh mesh =
        sweep(outlines, polyline<3>({{0, 0, 0}, {0, 0, 2}}, false), {.tessellation = {cells, 1}});
    expect_same_connectivity(mesh);
    const test::Measures m = test::measure(mesh);
    EXPECT_EQ(m.open_edges, 0u) << cells;
    EXPECT_NEAR(m.volume, 2 * (130 - holes), 1e-5) << cells;
    EXPECT_GT(m.smallest_triangle, 0) << cells;
    // A solid with twelve handles.
    EXPECT_EQ(m.euler, 2 - 2 * 12) << cells;
  }
}

}  // namespace
}  // namespace sweepkit::sweep
