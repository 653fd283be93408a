// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A closed sphere of 159,200 triangles seen from inside has no way out: 1e7 rays each at its vertices, the
// middles of its edges and the insides of its triangles, at the origin and where float32 leaves it 17 bits
// less.

#include <gtest/gtest.h>

#include <random>

#include "seads.hpp"
#include "sweep_hierarchy.hpp"
#include "sweep_meshes.hpp"

namespace sweepkit::render {
namespace {

constexpr int kRays = 10'000'000;

enum class Aim { kVertex, kEdge, kInside };

std::uint64_t misses(const MeshAccelerator& accelerator, const test::Shape& sphere, const glm::dvec3& middle,
                     Aim aim) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> real(0.05, 0.95);
  std::uint64_t misses = 0;
  for (int n = 0; n < kRays; ++n) {
    const sweep::Triangle& t = sphere.triangles[random() % sphere.triangles.size()];
    const glm::dvec3 a(sphere.positions[t[0]]);
    const glm::dvec3 b(sphere.positions[t[1]]);
    const glm::dvec3 c(sphere.positions[t[2]]);
    const double s = real(random);
    const glm::dvec3 target = aim == Aim::kVertex ? a
                              : aim == Aim::kEdge ? 0.5 * (a + b)
                                                  : (1 - s) * a + s * (0.5 * b + 0.5 * c);
    const glm::dvec3 origin = middle + 0.4 * (glm::dvec3(real(random), real(random), real(random)) - 0.5);
    Hit hit;
    accelerator.find_nearest({origin, target - origin}, 0, hit);
    misses += hit.is_hit() ? 0 : 1;
  }
  return misses;
}

class Leaks : public testing::TestWithParam<std::tuple<Accelerator, double>> {};

TEST_P(Leaks, AClosedSphereLeaksNoRayInThirtyMillion) {
  const auto& [kind, offset] = GetParam();
  const glm::dvec3 middle(offset, -offset, offset);
  const test::Shape sphere = test::moved(test::sphere(200, 400), 1, middle);
  ASSERT_EQ(sphere.triangles.size(), 159'200U);
  const scene::MeshView mesh = sphere.view();
  const auto accelerator = make_accelerator(mesh, kind);
  EXPECT_EQ(misses(*accelerator, sphere, middle, Aim::kVertex), 0U);
  EXPECT_EQ(misses(*accelerator, sphere, middle, Aim::kEdge), 0U);
  EXPECT_EQ(misses(*accelerator, sphere, middle, Aim::kInside), 0U);
}

INSTANTIATE_TEST_SUITE_P(Sphere, Leaks,
                         testing::Combine(testing::Values(Accelerator::kSeads, Accelerator::kSweep),
                                          testing::Values(0.0, 1e3)));

}  // namespace
}  // namespace sweepkit::render
