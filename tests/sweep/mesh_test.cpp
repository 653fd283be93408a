// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/mesh.hpp"

#include <gtest/gtest.h>

#include "mesh_measures.hpp"
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
