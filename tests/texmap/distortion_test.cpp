// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/distortion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh_shapes.hpp"
#include "sweepkit/texmap/right_triangle_layout.hpp"

namespace sweepkit::texmap {
namespace {

using test::Shape;

constexpr double kPi = std::numbers::pi;
// Positions and (u,v) are float32 of size 1 and steps of 1/64: a difference has a relative error of up to
// 64 * 2^-24 from each, and a ratio four of those.
constexpr double kFloat = 4 * 64 * 0x1p-23;

MappedSurface surface_of(const Shape& shape) {
  return {shape.positions, shape.texcoords, shape.triangles};
}

Distortion distortion_of(const Shape& shape) {
  return summarize(find_distortion(surface_of(shape)));
}

Shape rectangle(double width, double height) {
  return test::grid_of(8, 8,
                       [&](const glm::dvec2& uv) { return glm::dvec3(uv * glm::dvec2(width, height), 0); });
}

TEST(Distortion, ASquareUnderASquareTextureHasNone) {
  const Shape square = rectangle(1, 1);
  const Distortion d = distortion_of(square);
  EXPECT_EQ(d.u_homogeneity, 1);
  EXPECT_EQ(d.v_homogeneity, 1);
  EXPECT_EQ(d.aspect_ratio.mean, 1);
  EXPECT_EQ(d.aspect_ratio.worst, 1);
  EXPECT_EQ(d.density_95, 1);
  EXPECT_EQ(d.area, 1);
  for (const double ratio : find_inhomogeneity(find_distortion(surface_of(square))))
    EXPECT_NEAR(ratio, 1, 1e-15);
}

// Stretched one way it is homogeneous still: every step along u is four times as long as one along v.
TEST(Distortion, AStretchedPlaneHasTheStretchForItsAspectRatio) {
  const Distortion d = distortion_of(rectangle(4, 1));
  EXPECT_EQ(d.u_homogeneity, 1);
  EXPECT_EQ(d.v_homogeneity, 1);
  EXPECT_EQ(d.aspect_ratio.mean, 4);
  EXPECT_EQ(d.aspect_ratio.median, 4);
  EXPECT_EQ(d.aspect_ratio.percentile_95, 4);
  EXPECT_EQ(d.aspect_ratio.worst, 4);
}

TEST(Distortion, ArcsAreMetresAUnitOfTheTexture) {
  for (const TriangleDistortion& t : find_distortion(surface_of(rectangle(3, 0.5)))) {
    EXPECT_EQ(t.u_arc, 3);
    EXPECT_EQ(t.v_arc, 0.5);
    EXPECT_NEAR(t.area, 1.5 / 128, 1e-9);
    EXPECT_EQ(t.uv_area, 1.0 / 128);
  }
}

// n chords go round a cylinder of radius r and height h: 2 n r sin(pi / n) to h.
TEST(Distortion, ACylinderHasTheChordsToItsHeightForItsAspectRatio) {
  const double r = 0.5;
  const double h = 2;
  const Shape cylinder = test::grid_of(64, 8, [&](const glm::dvec2& uv) {
    return glm::dvec3(r * std::cos(2 * kPi * uv.x), h * uv.y, -r * std::sin(2 * kPi * uv.x));
  });
  const Distortion d = distortion_of(cylinder);
  const double around = 2 * 64 * r * std::sin(kPi / 64);
  EXPECT_NEAR(d.u_homogeneity, 1, kFloat);
  EXPECT_NEAR(d.v_homogeneity, 1, kFloat);
  EXPECT_NEAR(d.aspect_ratio.mean, around / h, kFloat * around / h);
}

// A cone cut off from radius 1 to radius q: a triangle's steps along u are those of the ring its leg lies on,
// so the largest is that of radius 1 and the smallest that of radius q.
TEST(Distortion, ACutConeHasItsRadiiForItsHomogeneity) {
  const double q = 0.25;
  const Shape cone = test::grid_of(64, 16, [&](const glm::dvec2& uv) {
    const double r = 1 + (q - 1) * uv.y;
    return glm::dvec3(r * std::cos(2 * kPi * uv.x), 2 * uv.y, -r * std::sin(2 * kPi * uv.x));
  });
  const Distortion d = distortion_of(cone);
  EXPECT_NEAR(d.u_homogeneity, 1 / q, 4 * kFloat / q);
  // Every step along v is a stretch of a straight line from the base towards the apex: all are equal.
  EXPECT_NEAR(d.v_homogeneity, 1, kFloat);
  // By area u's arcs run from 1 down to q; the middle 95 % cannot reach further.
  EXPECT_LT(d.u_homogeneity_95, d.u_homogeneity);
  EXPECT_GT(d.u_homogeneity_95, 2);
}

// Towards a pole the steps along u shrink with the ring: sin(pi / rows) of the equator's at the last ring.
TEST(Distortion, APoleSpoilsTheHomogeneityButNotItsPercentiles) {
  const std::uint32_t rows = 32;
  Shape sphere = test::grid_of(64, rows, [](const glm::dvec2& uv) {
    const double r = std::sin(kPi * uv.y);
    return glm::dvec3(r * std::cos(2 * kPi * uv.x), -std::cos(kPi * uv.y), -r * std::sin(2 * kPi * uv.x));
  });
  // Rounding leaves the poles' triangles a little area; as sweep meshes do, they are left out.
  std::erase_if(sphere.triangles, [&](const auto& t) {
    const auto is_pole = [&](std::uint32_t vertex) { return vertex < 65 || vertex >= 65 * rows; };
    return (is_pole(t[0]) && is_pole(t[2])) || (is_pole(t[1]) && is_pole(t[2])) ||
           (is_pole(t[0]) && is_pole(t[1]));
  });
  const Distortion d = distortion_of(sphere);
  const double last = std::sin(kPi / rows);
  EXPECT_NEAR(d.u_homogeneity, 1 / last, 1e-3 / last);
  // The caps of 2.5 % of the area end where cos is 0.975, 2.28 rings from the poles: arcs are those of ring 2
  // or 3 there, and the equator's but for 0.1 % at the other end.
  EXPECT_LT(d.u_homogeneity_95, 1 / std::sin(2 * kPi / rows) + 0.01);
  EXPECT_GT(d.u_homogeneity_95, 1 / std::sin(3 * kPi / rows) - 0.01);
  EXPECT_EQ(d.degenerate_triangles, 0u);
}

TEST(Distortion, CountsTrianglesWithoutTextureAndMirroredOnesApart) {
  Shape shape;
  shape.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 0, 0}};
  shape.texcoords = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {1, 0}};
  shape.triangles = {{0, 1, 2}, {1, 4, 3}, {0, 2, 1}, {0, 0, 1}};
  const Distortion d = distortion_of(shape);
  EXPECT_EQ(d.degenerate_triangles, 1u);
  EXPECT_EQ(d.mirrored_triangles, 1u);
  EXPECT_EQ(d.aspect_ratio.worst, 1);
  const std::vector<TriangleDistortion> all = find_distortion(surface_of(shape));
  EXPECT_TRUE(std::isinf(all[1].aspect_ratio()));
  EXPECT_TRUE(std::isinf(find_inhomogeneity(all)[1]));
  EXPECT_EQ(summarize({}).aspect_ratio.worst, 1);
}

// Two triangles of 3 and 1 square metres, aspect ratios 2 and 6.
TEST(Distortion, WeighsByArea) {
  const std::vector<TriangleDistortion> two = {{2, 1, 3, 0.5}, {1, 6, 1, 0.5}};
  const Distortion d = summarize(two);
  EXPECT_EQ(d.aspect_ratio.mean, 0.75 * 2 + 0.25 * 6);
  EXPECT_EQ(d.aspect_ratio.median, 2);
  EXPECT_EQ(d.aspect_ratio.percentile_95, 6);
  EXPECT_EQ(d.u_homogeneity, 2);
  EXPECT_EQ(d.v_homogeneity, 6);
  EXPECT_EQ(d.density_95, 3);
}

TEST(Distortion, IsTheSameForEverySizeAndPlaceOfTheTexture) {
  Shape torus = test::torus(16, 24);
  const Distortion before = distortion_of(torus);
  for (glm::vec2& uv : torus.texcoords) uv = 4.0f * uv;
  for (glm::vec3& p : torus.positions) p *= 0x1p20f;
  const Distortion after = distortion_of(torus);
  EXPECT_EQ(after.u_homogeneity, before.u_homogeneity);
  EXPECT_EQ(after.aspect_ratio.mean, before.aspect_ratio.mean);
}

TEST(EdgeContinuity, ATorusIsOpenAlongACircleEachWay) {
  const EdgeContinuity count = count_continuous_edges(surface_of(test::torus(16, 24)));
  EXPECT_EQ(count.interior_edges, 3u * 16 * 24);
  EXPECT_EQ(count.interior_edges - count.continuous_edges, 16u + 24);
}

TEST(EdgeContinuity, AgreesWithTheLayoutThatMadeIt) {
  Shape sphere = test::soup_of(test::icosphere(3));
  const RightTriangleLayout layout = lay_out_right_triangles(sphere.positions, sphere.triangles);
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
    for (const glm::dvec2& uv : layout.texcoords(t)) sphere.texcoords.push_back(glm::vec2(uv));
  }
  const EdgeContinuity count = count_continuous_edges(surface_of(sphere));
  EXPECT_EQ(count.interior_edges, layout.interior_edges);
  EXPECT_EQ(count.continuous_edges, layout.continuous_edges);
  EXPECT_EQ(find_overlap(surface_of(sphere)), 0);
}

TEST(Overlap, IsNoneOfAGridAndAllOfTwoOnTopOfEachOther) {
  Shape grid = test::plane(13, 7);
  EXPECT_EQ(find_overlap(surface_of(grid)), 0);
  const std::vector<std::array<std::uint32_t, 3>> once = grid.triangles;
  grid.triangles.insert(grid.triangles.end(), once.begin(), once.end());
  EXPECT_EQ(find_overlap(surface_of(grid)), 1);
}

// The unit square and a quarter of it once more.
TEST(Overlap, IsTheShareOfWhatIsCovered) {
  Shape shape = rectangle(1, 1);
  const auto first = static_cast<std::uint32_t>(shape.positions.size());
  shape.positions.insert(shape.positions.end(), {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
  shape.texcoords.insert(shape.texcoords.end(), {{0, 0}, {0.5, 0}, {0, 0.5}, {0.5, 0.5}});
  shape.triangles.push_back({first, first + 1, first + 2});
  shape.triangles.push_back({first + 1, first + 3, first + 2});
  EXPECT_EQ(find_overlap(surface_of(shape)), 0.25);
}

}  // namespace
}  // namespace sweepkit::texmap
