// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/triangle_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesh_measures.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep {
namespace {

// A swept torus as plain arrays, every place once.
struct Lists {
  std::vector<glm::dvec3> positions;
  std::vector<Triangle> triangles;
  std::vector<std::array<glm::vec2, 3>> texcoords;

  TriangleSurface surface() const { return {positions, triangles, texcoords, {}}; }
};

Lists lists_of(const Mesh& mesh) {
  Lists lists;
  std::map<std::array<float, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> place;
  for (const glm::vec3& p : mesh.positions()) {
    const auto [found, is_new] = places.emplace(std::array{p.x, p.y, p.z}, places.size());
    if (is_new) lists.positions.push_back(glm::dvec3(p) + mesh.origin);
    place.push_back(found->second);
  }
  for (const Triangle& t : mesh.triangles) {
    lists.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
    lists.texcoords.push_back({mesh.texcoords()[t[0]], mesh.texcoords()[t[1]], mesh.texcoords()[t[2]]});
  }
  return lists;
}

Lists torus() {
  return lists_of(sweep(circle_contour(0.25), circle_trajectory(1), {.tessellation = {16, 32}}));
}

// Every half-edge and its twin, next and previous, face and vertices belong together.
void expect_sound_half_edges(const Mesh& mesh) {
  ASSERT_EQ(mesh.n_faces(), mesh.triangles.size());
  std::size_t inner = 0;
  for (std::size_t i = 0; i < mesh.n_halfedges(); ++i) {
    const OpenMesh::HalfedgeHandle h(static_cast<int>(i));
    ASSERT_EQ(mesh.prev_halfedge_handle(mesh.next_halfedge_handle(h)), h);
    ASSERT_EQ(mesh.from_vertex_handle(mesh.next_halfedge_handle(h)), mesh.to_vertex_handle(h));
    ASSERT_EQ(mesh.face_handle(mesh.next_halfedge_handle(h)), mesh.face_handle(h));
    inner += mesh.is_boundary(h) ? 0 : 1;
  }
  EXPECT_EQ(inner, 3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::vector<std::uint32_t> corners;
    for (const auto vertex : mesh.fv_range(OpenMesh::FaceHandle(static_cast<int>(t))))
      corners.push_back(static_cast<std::uint32_t>(vertex.idx()));
    std::vector<std::uint32_t> own(mesh.triangles[t].begin(), mesh.triangles[t].end());
    std::sort(corners.begin(), corners.end());
    std::sort(own.begin(), own.end());
    ASSERT_EQ(corners, own);
  }
}

TEST(TriangleSurface, MakesASweptTorusAgain) {
  const Lists lists = torus();
  const Mesh mesh = mesh_of(lists.surface());
  const test::Measures m = test::measure(mesh);
  EXPECT_EQ(m.open_edges, 0u);
  EXPECT_EQ(m.euler, 0);
  EXPECT_GT(m.volume, 0);
  EXPECT_LT(m.worst_normal_length, 1e-6);
  // One sheet, and as many vertices as the sweep has: a seam each way.
  EXPECT_EQ(mesh.areas.size(), 1u);
  EXPECT_EQ(mesh.n_vertices(), 17u * 33);
  expect_sound_half_edges(mesh);
}

// Against the surface's own normals: a vertex normal from triangles is second order in their size, here
// (2 pi / 16)^2 / 2 of a radian at most and mostly less by symmetry.
TEST(TriangleSurface, FindsTheNormalsOfATorus) {
  const Lists lists = torus();
  const Mesh mesh = mesh_of(lists.surface());
  for (std::size_t i = 0; i < mesh.n_vertices(); ++i) {
    const glm::dvec3 p = test::position(mesh, static_cast<std::uint32_t>(i));
    const glm::dvec3 ring = glm::normalize(glm::dvec3(p.x, 0, p.z));
    EXPECT_GT(glm::dot(glm::normalize(p - ring), glm::dvec3(mesh.normals()[i])), std::cos(0.077));
  }
}

TEST(TriangleSurface, KeepsTheAreasTogether) {
  Lists lists = torus();
  std::mt19937_64 random(3);
  // Two islands, their triangles in any order.
  for (std::size_t t = 0; t < lists.triangles.size(); ++t) {
    const bool is_high = lists.texcoords[t][1].y + lists.texcoords[t][0].y + lists.texcoords[t][2].y > 1.5f;
    for (glm::vec2& uv : lists.texcoords[t]) uv.x += is_high ? 5.0f : 0.0f;
  }
  for (std::size_t i = lists.triangles.size(); i > 1; --i) {
    const std::size_t other = random() % i;
    std::swap(lists.triangles[i - 1], lists.triangles[other]);
    std::swap(lists.texcoords[i - 1], lists.texcoords[other]);
  }
  const Mesh mesh = mesh_of(lists.surface());
  ASSERT_EQ(mesh.areas.size(), 2u);
  std::uint32_t next = 0;
  for (const Area& area : mesh.areas) {
    EXPECT_EQ(area.first_triangle, next);
    next += area.triangle_count;
    const bool is_high = mesh.texcoords()[mesh.triangles[area.first_triangle][0]].x >= 5;
    for (std::uint32_t t = area.first_triangle; t < next; ++t)
      EXPECT_EQ(mesh.texcoords()[mesh.triangles[t][1]].x >= 5, is_high);
  }
  EXPECT_EQ(next, mesh.triangles.size());
  EXPECT_FALSE(mesh.areas[0].continues_sheet);
  EXPECT_TRUE(mesh.areas[1].continues_sheet);
  expect_sound_half_edges(mesh);
}

// Three triangles at an edge, one turned over, one twice, two that touch in a point: no surface, and
// half-edges that hang together all the same.
TEST(TriangleSurface, WritesHalfEdgesOfWhatIsNoManifold) {
  const std::vector<glm::dvec3> positions = {{0, 0, 0},  {1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                             {0, -1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 0, 2},
                                           {0, 1, 2}, {0, 5, 6}, {1, 2, 3}};
  const Mesh mesh = mesh_of({positions, triangles, {}, {}});
  expect_sound_half_edges(mesh);
}

TEST(TriangleSurface, KeepsPositionsNearTheirOrigin) {
  std::vector<glm::dvec3> positions = {{1e8, 0, 0}, {1e8 + 1e-3, 0, 0}, {1e8, 1e-3, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const Mesh mesh = mesh_of({positions, triangles, {}, {}});
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_LT(glm::distance(test::position(mesh, i), positions[i]), 2e-8);
  positions = {{0, 0, 0}, {1e-40, 0, 0}, {0, 1e-40, 0}};
  EXPECT_THROW(mesh_of({positions, triangles, {}, {}}), InputError);
}

}  // namespace
}  // namespace sweepkit::sweep
