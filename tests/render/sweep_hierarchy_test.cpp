// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweep_hierarchy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hard_rays.hpp"
#include "linear_scan.hpp"

namespace sweepkit::render {
namespace {

using test::Shape;

#ifdef SWEEPKIT_LONG_TEST
constexpr int kRays = 3000;
#else
constexpr int kRays = 96;
#endif

void expect_same(const Hit& hit, const Hit& expected) {
  ASSERT_EQ(hit.object, expected.object);
  ASSERT_EQ(hit.triangle, expected.triangle);
  ASSERT_EQ(hit.t, expected.t);
  ASSERT_EQ(hit.a, expected.a);
  ASSERT_EQ(hit.b, expected.b);
  ASSERT_EQ(hit.c, expected.c);
}

TEST(SweepHierarchy, FindsTheSameHitsAsALinearScanToTheBit) {
  for (const Shape& shape : test::crowd()) {
    const scene::MeshView mesh = shape.view();
    const LinearScan linear(mesh);
    const SweepHierarchy hierarchy(mesh);
    int hits = 0;
    int n = 0;
    for (const Ray& ray : test::hard_rays(shape, kRays)) {
      SCOPED_TRACE(shape.name + ", ray " + std::to_string(n++));
      Hit expected;
      linear.find_nearest(ray, 7, expected);
      Hit hit;
      hierarchy.find_nearest(ray, 7, hit);
      ASSERT_NO_FATAL_FAILURE(expect_same(hit, expected));
      hits += expected.is_hit() ? 1 : 0;
      // Neither at the hit itself nor before it, but right behind it; and somewhere.
      for (const double end : {expected.t, std::nextafter(expected.t, kNoEnd), 0.9, 2.0})
        ASSERT_EQ(hierarchy.is_blocked(ray, 7, end), linear.is_blocked(ray, 7, end));
      // A hit from elsewhere, nearer, farther or at the same place of a lower or higher object, stays or
      // goes.
      for (const double t : {0.5 * expected.t, expected.t, 2 * expected.t}) {
        for (const std::uint32_t object : {3u, 8u}) {
          Hit best;
          best.t = t;
          best.object = object;
          Hit expected_best = best;
          linear.find_nearest(ray, 7, expected_best);
          hierarchy.find_nearest(ray, 7, best);
          ASSERT_NO_FATAL_FAILURE(expect_same(best, expected_best));
        }
      }
    }
    // Half of the rays are aimed at the mesh; what is pressed flat is seldom hit.
    if (shape.name == "vase") {
      EXPECT_GT(hits, kRays / 2);
    }
  }
}

// Bundles of rays of one origin, from a hair to wider than a packet may be; the middle one is hard.
TEST(SweepHierarchy, APacketFindsTheSameHitsAsItsRaysAloneToTheBit) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> real(-1, 1);
  for (const Shape& shape : test::crowd()) {
    const scene::MeshView mesh = shape.view();
    const LinearScan linear(mesh);
    const SweepHierarchy hierarchy(mesh);
    int n = 0;
    for (const Ray& middle : test::hard_rays(shape, kRays / 4)) {
      SCOPED_TRACE(shape.name + ", packet " + std::to_string(n++));
      const double width = glm::length(middle.direction) * std::pow(10, -4 * (0.5 + 0.5 * real(random)));
      std::vector<Ray> rays(1 + random() % 18, middle);
      for (std::size_t i = 1; i < rays.size(); ++i) {
        rays[i].direction += width * glm::dvec3(real(random), real(random), real(random));
        if (i % 5 == 1) rays[i].direction[n % 3] = i % 2 == 0 ? 0.0 : -0.0;
        if (i % 7 == 2) rays[i].direction *= std::abs(real(random)) + 1e-3;
      }
      // Some have been stopped before, nearer or farther, by another object.
      std::vector<Hit> best(rays.size());
      if (n % 3 == 0) {
        for (std::size_t i = 0; i < best.size(); i += 2) {
          best[i].t = std::abs(real(random));
          best[i].object = i % 4 == 0 ? 3 : 8;
        }
      }
      std::vector<Hit> expected = best;
      linear.find_nearest(rays, 7, expected);
      hierarchy.find_nearest(rays, 7, best);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        SCOPED_TRACE("ray " + std::to_string(i));
        ASSERT_NO_FATAL_FAILURE(expect_same(best[i], expected[i]));
      }
    }
  }
}

TEST(SweepHierarchy, EveryInstructionSetFindsTheSameToTheBit) {
  for (const Shape& shape : test::crowd()) {
    const scene::MeshView mesh = shape.view();
    const LinearScan linear(mesh);
    for (const std::string& instruction_set : instruction_sets()) {
      SCOPED_TRACE(shape.name + ", " + instruction_set);
      const SweepHierarchy hierarchy(mesh, instruction_set);
      int n = 0;
      for (const Ray& ray : test::hard_rays(shape, kRays / 2)) {
        SCOPED_TRACE(n++);
        std::vector<Ray> rays(4, ray);
        for (std::size_t i = 1; i < rays.size(); ++i)
          rays[i].direction *= 1.0 + 1e-3 * glm::dvec3(static_cast<double>(i), 1, -static_cast<double>(i));
        std::vector<Hit> expected(rays.size());
        linear.find_nearest(rays, 7, expected);
        std::vector<Hit> hits(rays.size());
        hierarchy.find_nearest(rays, 7, hits);
        for (std::size_t i = 0; i < rays.size(); ++i)
          ASSERT_NO_FATAL_FAILURE(expect_same(hits[i], expected[i]));
        Hit hit;
        hierarchy.find_nearest(ray, 7, hit);
        ASSERT_NO_FATAL_FAILURE(expect_same(hit, expected[0]));
        ASSERT_EQ(hierarchy.is_blocked(ray, 7, 1.5), linear.is_blocked(ray, 7, 1.5));
      }
    }
  }
}

TEST(SweepHierarchy, RaysWithoutNumbersHitNothing) {
  const Shape shape = test::trefoil(12, 90);
  const scene::MeshView mesh = shape.view();
  const SweepHierarchy hierarchy(mesh);
  const double nan = std::nan("");
  const double infinity = kNoEnd;
  for (const Ray& ray :
       {Ray{{nan, 0, 0}, {0, -1, 0}}, Ray{{0, 1, 0}, {nan, nan, nan}}, Ray{{0, 0, 0}, {0, 0, 0}},
        Ray{{infinity, 0, 0}, {-1, 0, 0}}, Ray{{0, 0, 0}, {infinity, 0, 0}}, Ray{{2, 0, 0}, {0, nan, 1}}}) {
    const std::vector<Ray> rays(16, ray);
    std::vector<Hit> hits(16);
    hierarchy.find_nearest(rays, 0, hits);
    EXPECT_FALSE(hits[15].is_hit());
    Hit hit;
    hierarchy.find_nearest(ray, 0, hit);
    EXPECT_FALSE(hit.is_hit());
    EXPECT_FALSE(hierarchy.is_blocked(ray, 0, kNoEnd));
  }
}

// Directions and origins whose squares are no numbers any more.
TEST(SweepHierarchy, RaysOfHugeAndTinyNumbersHitWhatALinearScanHits) {
  const Shape shape = test::sphere(12, 20);
  const scene::MeshView mesh = shape.view();
  const SweepHierarchy hierarchy(mesh);
  const LinearScan linear(mesh);
  for (const double size : {1e-310, 1e-200, 1e200, 1e307}) {
    for (const Ray& ray : {Ray{{0, 0, 0}, {size, 0.3 * size, -0.2 * size}},
                           Ray{{size, 0.1, 0.2}, {-size, 0, 0}}, Ray{{0.1, 0.2, -size}, {0, 0, 1}}}) {
      Hit expected;
      linear.find_nearest(ray, 0, expected);
      Hit hit;
      hierarchy.find_nearest(ray, 0, hit);
      ASSERT_NO_FATAL_FAILURE(expect_same(hit, expected));
    }
  }
}

// Boxes of six floats for leaves of 14 to 18 triangles, and a fifteenth of that above them.
TEST(SweepHierarchy, TakesTwoBytesATriangleAtMost) {
  for (const Shape& shape : {test::vase(172, 300), test::trefoil(60, 833), test::sphere(200, 260)}) {
    const scene::MeshView mesh = shape.view();
    const SweepHierarchy hierarchy(mesh);
    EXPECT_LE(static_cast<double>(hierarchy.bytes()), 2.0 * static_cast<double>(mesh.triangles.size()))
        << shape.name;
  }
}

}  // namespace
}  // namespace sweepkit::render
