// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/mesh.hpp"

#include <gtest/gtest.h>

#include "mesh_measures.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::sweep {
namespace {

TEST(Mesh, SpansLookAtOpenMeshsOwnStorage) {
  Mesh mesh = plane({2, 2});
  EXPECT_EQ(static_cast<const void*>(mesh.positions().data()), static_cast<const void*>(mesh.points()));
  mesh.set_point(OpenMesh::VertexHandle(0), {7, 8, 9});
  EXPECT_EQ(mesh.positions()[0], glm::vec3(7, 8, 9));
}

TEST(Mesh, AppendMovesPositionsNormalsAndKeepsTheOutside) {
  const Mesh torus = sweep(circle_contour(0.3), circle_trajectory(1), {.tessellation = {16, 32}});
  glm::dmat4 placement(1.0);
  placement[0][0] = -2;  // a mirror and a stretch
  placement[3] = glm::dvec4(5, 6, 7, 1);
  Mesh moved;
  append(moved, torus, placement);
  const test::Measures before = test::measure(torus);
  const test::Measures after = test::measure(moved);
  EXPECT_NEAR(after.volume, 2 * before.volume, 1e-5);
  EXPECT_EQ(after.open_edges, 0u);
  // A cell turns by up to 22.5 degrees; twice as long along x its tangent doubles: 39.6 degrees, cosine 0.77.
  EXPECT_GT(after.worst_normal_cosine, 0.77);
  EXPECT_LT(after.worst_normal_length, 1e-6);
}

TEST(Mesh, AppendsWithoutHalfEdgesToo) {
  const Mesh part = plane({1, 1}, {.tessellation = {2, 2}, .has_half_edges = false});
  Mesh whole;
  append(whole, part, glm::dmat4(1.0));
  append(whole, part, glm::dmat4(1.0));
  EXPECT_EQ(whole.n_vertices(), 18u);
  EXPECT_EQ(whole.triangles.size(), 16u);
  EXPECT_EQ(whole.half_edge_bytes(), 0u);
  EXPECT_EQ(whole.patches[1].vertex(0, 0), 9u);
  EXPECT_EQ(whole.patches[1].first_triangle, 8u);
  EXPECT_EQ(whole.patches[1].area, 1u);
  EXPECT_EQ(whole.areas[1].first_triangle, 8u);
}

TEST(Mesh, TellsTheBytesThatOpenMeshHolds) {
  for (const bool has_half_edges : {false, true}) {
    const Mesh mesh = sweep(circle_contour(0.3), circle_trajectory(1),
                            {.tessellation = {16, 32}, .has_half_edges = has_half_edges});
    // Handles: a vertex has one (a half-edge), a half-edge four (face, end, next, previous), a face one.
    std::size_t held = mesh.triangles.size() * sizeof(Triangle) +
                       sizeof(int) * (mesh.n_vertices() + 4 * mesh.n_halfedges() + mesh.n_faces());
    const auto add = [&](auto property, auto end, std::size_t count) {
      for (; property != end; ++property) {
        // The items' own data is an empty struct, whose size OpenMesh tells nobody: a byte.
        if (*property != nullptr)
          held += count * ((*property)->element_size() < 100 ? (*property)->element_size() : 1);
      }
    };
    add(mesh.vprops_begin(), mesh.vprops_end(), mesh.n_vertices());
    add(mesh.hprops_begin(), mesh.hprops_end(), mesh.n_halfedges());
    add(mesh.eprops_begin(), mesh.eprops_end(), mesh.n_edges());
    add(mesh.fprops_begin(), mesh.fprops_end(), mesh.n_faces());
    EXPECT_EQ(mesh.bytes(), held);
    EXPECT_EQ(mesh.half_edge_bytes() > 0, has_half_edges);
  }
}

TEST(Mesh, TheSameInputGivesTheSameBytes) {
  const auto make = [] {
    return sweep(circle_contour(0.3), circle_trajectory(1), {.tessellation = {33, 65}});
  };
  const Mesh one = make();
  const Mesh two = make();
  for (std::size_t i = 0; i < one.n_vertices(); ++i) {
    ASSERT_EQ(one.positions()[i], two.positions()[i]);
    ASSERT_EQ(one.normals()[i], two.normals()[i]);
  }
  EXPECT_EQ(one.triangles, two.triangles);
}

TEST(Mesh, OriginIsZeroForWhateverLiesAboutTheWorldsOrigin) {
  EXPECT_EQ(sweep(circle_contour(0.3), circle_trajectory(1)).origin, glm::dvec3(0.0));
  EXPECT_EQ(revolve(polyline<2>({{0.1, 0}, {0.15, 0.4}}, false)).origin, glm::dvec3(0.0));
}

}  // namespace
}  // namespace sweepkit::sweep
