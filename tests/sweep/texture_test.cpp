// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Sizes of textures in metres, and tangents.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"
#include "sweepkit/sweep/tangents.hpp"

namespace sweepkit::sweep {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<glm::vec4> tangents_of(const Mesh& mesh) {
  return find_tangents(mesh.positions(), mesh.normals(), mesh.texcoords(), mesh.triangles);
}

// Of the wall, which is the first patch.
glm::vec2 largest_texcoord(const Mesh& mesh) {
  const GridPatch& wall = mesh.patches.front();
  glm::vec2 largest(0.0f);
  for (std::size_t k = 0; k < 2 * wall.columns * std::size_t{wall.rows}; ++k) {
    for (const std::uint32_t vertex : mesh.triangles[wall.first_triangle + k])
      largest = glm::max(largest, mesh.texcoords()[vertex]);
  }
  return largest;
}

TEST(TextureSize, IsKeptAlongWhatIsOpen) {
  const Curve3 line = polyline<3>({{0, 0, 0}, {0, 0, 3}}, false);
  const Mesh mesh = sweep(polyline<2>({{0, 0}, {1, 0}}, false), line, {.uv = {.size = glm::dvec2(0.4, 0.8)}});
  EXPECT_FLOAT_EQ(largest_texcoord(mesh).x, 2.5f);
  EXPECT_FLOAT_EQ(largest_texcoord(mesh).y, 3.75f);
  const Mesh ground = plane({3, 2}, {.uv = {.size = glm::dvec2(0.5, 0.4)}});
  EXPECT_EQ(largest_texcoord(ground), glm::vec2(6, 5));
}

TEST(TextureSize, MakesWholeRepeatsRoundWhatIsClosed) {
  // A circle of 2 pi 0.3 = 1.885 m along one of 6.283 m.
  const auto repeats = [](double size) {
    return largest_texcoord(
        sweep(circle_contour(0.3), circle_trajectory(1), {.uv = {.size = glm::dvec2(size)}}));
  };
  EXPECT_EQ(repeats(0.4), glm::vec2(5, 16));  // 4.71 and 15.7
  EXPECT_EQ(repeats(0.5), glm::vec2(4, 13));  // 3.77 and 12.6
  EXPECT_EQ(repeats(100), glm::vec2(1, 1));
}

TEST(TextureSize, OfATurnIsMeasuredWhereItIsWidest) {
  const Curve2 cone = polyline<2>({{0.2, 0}, {0.5, 1}}, false);
  const glm::vec2 whole = largest_texcoord(revolve(cone, {.uv = {.size = glm::dvec2(0.5)}}));
  EXPECT_EQ(whole.x, 6);  // pi / 0.5 = 6.28
  EXPECT_NEAR(whole.y, std::hypot(0.3, 1) / 0.5, 1e-6);
  const glm::vec2 half = largest_texcoord(revolve(cone, {.uv = {.size = glm::dvec2(0.5)}, .angle_deg = 180}));
  EXPECT_NEAR(half.x, kPi, 1e-6);
}

TEST(TextureSize, IsRefusedUnlessItIsALength) {
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(plane({1, 1}, {.uv = {.size = glm::dvec2(1, bad)}}), InputError) << bad;
}

TEST(Tangents, OfAPlaneAreItsAxes) {
  for (const glm::vec4& tangent : tangents_of(plane({3, 2}, {.tessellation = {4, 3}})))
    EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
}

TEST(Tangents, OfATorusRunRoundItsTube) {
  const Mesh mesh = sweep(circle_contour(0.3), circle_trajectory(1), {.tessellation = {48, 96}});
  const std::vector<glm::vec4> tangents = tangents_of(mesh);
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const glm::dvec3 p = mesh.positions()[i];
    const glm::dvec3 out = glm::normalize(glm::dvec3(p.x, 0, p.z));
    const glm::dvec3 arm = (p - out) / 0.3;
    // Along the trajectory, counter-clockwise from above; u runs right-handed about it.
    const glm::dvec3 forward(out.z, 0, -out.x);
    const glm::dvec3 exact = glm::cross(forward, arm);
    const glm::dvec3 tangent(tangents[i]);
    EXPECT_NEAR(glm::length(tangent), 1, 1e-6);
    EXPECT_NEAR(glm::dot(tangent, glm::dvec3(mesh.normals()[i])), 0, 1e-6);
    // The mean over the cells about a vertex is exact up to their bend to second order: (2 pi / 48)^2 / 4.
    EXPECT_LT(glm::length(tangent - exact), 5e-3) << i;
    EXPECT_EQ(tangents[i].w, 1);
  }
}

TEST(Tangents, AreTheSameOnBothSidesOfASeam) {
  const Mesh mesh = sweep(circle_contour(0.3), helix(1, 1, 1), {.caps = Caps::kNone});
  const std::vector<glm::vec4> tangents = tangents_of(mesh);
  std::map<std::array<float, 3>, std::size_t> at;
  int doubled = 0;
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const glm::vec3 p = mesh.positions()[i];
    const auto [other, is_new] = at.emplace(std::array<float, 3>{p.x, p.y, p.z}, i);
    if (is_new) continue;
    ++doubled;
    EXPECT_EQ(tangents[i], tangents[other->second]);
  }
  EXPECT_EQ(doubled, 65);
}

TEST(Tangents, TellMirroredTexturesByTheirHandedness) {
  for (const glm::vec4& tangent : tangents_of(plane({1, 1}, {.uv = {.repeat = {-1, 1}}})))
    EXPECT_EQ(tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(Tangents, AreUnitAndUprightAtPolesAndWhereTextureTellsNothing) {
  const Mesh vase = revolve(bezier_curve<2>({{0, 0}, {1, 0}, {0.2, 1.5}, {0, 2}}));
  const Mesh blank = plane({1, 1}, {.uv = {.repeat = {0, 0}}});
  for (const Mesh* mesh : {&vase, &blank}) {
    const std::vector<glm::vec4> tangents = tangents_of(*mesh);
    for (std::size_t i = 0; i < tangents.size(); ++i) {
      EXPECT_NEAR(glm::length(glm::dvec3(tangents[i])), 1, 1e-6);
      EXPECT_NEAR(glm::dot(glm::dvec3(tangents[i]), glm::dvec3(mesh->normals()[i])), 0, 1e-6);
      EXPECT_EQ(std::abs(tangents[i].w), 1);
    }
  }
}

}  // namespace
}  // namespace sweepkit::sweep
