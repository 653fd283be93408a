// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The default map's promise against quadruple precision, for every kind of hard triangle and hit. Built
// twice: with 100,000 pairs of each kind into the fast tests, with 3,000,000 into a program of its own.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "adversarial_triangles.hpp"
#include "sweepkit/texmap/area_ratio_mapping.hpp"

#ifndef SWEEPKIT_MAP_PAIRS
#define SWEEPKIT_MAP_PAIRS 100000
#endif

namespace sweepkit::texmap {
namespace {

class AreaRatioMapHard : public testing::TestWithParam<int> {};

// Legs of both signs and of unequal lengths, a corner off zero.
const RightTriangle kTexture{{0.25, -3}, -0.5, 2};

struct Bound {
  double u, v;
};

// 8 steps of the conditioning times the leg, and the last rounding of (u,v) itself, which a corner that is
// not 0 may make the larger one.
template <class Real>
Bound bound_of(const ExactMap& exact, const glm::dvec2& uv) {
  return {kEpsilon<Real> * (8 * exact.conditioning_c * std::abs(kTexture.bc) + std::abs(uv.x)),
          kEpsilon<Real> * (8 * exact.conditioning_a * std::abs(kTexture.ba) + std::abs(uv.y))};
}

template <class Real>
void expect_promise(Hardness hardness) {
  for (std::uint64_t number = 0; number < SWEEPKIT_MAP_PAIRS; ++number) {
    const MapCase<Real> sample = make_case<Real>(hardness, number);
    const auto prepared = AreaRatioMap::prepare(sample.triangle, kTexture);
    const ExactMap exact = exact_map(sample, prepared.i, prepared.j);
    ASSERT_EQ(exact.has_area || prepared.ba == decltype(prepared.ba)(0), true) << number;
    const Quad u = kTexture.b.x + exact.c * kTexture.bc;
    const Quad v = kTexture.b.y + exact.a * kTexture.ba;
    for (const auto& mapped : {AreaRatioMap::map(prepared, sample.triangle, kTexture, sample.hit),
                               area_ratio_map(sample.triangle, kTexture, sample.hit)}) {
      ASSERT_TRUE(std::isfinite(mapped.x) && std::isfinite(mapped.y)) << number;
      if (!exact.has_area) {
        ASSERT_EQ(glm::dvec2(mapped), kTexture.b) << number;
        continue;
      }
      const Bound bound = bound_of<Real>(exact, {static_cast<double>(u), static_cast<double>(v)});
      ASSERT_LE(std::abs(static_cast<double>(u - mapped.x)), bound.u) << number;
      ASSERT_LE(std::abs(static_cast<double>(v - mapped.y)), bound.v) << number;
      ASSERT_TRUE(exact.is_dominant) << number;
    }
  }
}

// Corners so near to a line that the area is no larger than what rounding does to it.
MapCase<double> area_in_its_rounding(std::uint64_t number) {
  CaseRandom random(number);
  MapCase<double> sample;
  auto& [a, b, c] = sample.triangle;
  b = random.power_of_ten(-6, 0) * random.in_cube();
  c = random.in_cube();
  a = b + random.between(-0.2, 1.2) * (c - b) + random.power_of_ten(-20, -14) * random.in_cube();
  sample.hit = b + random.between(-0.5, 1.5) * (c - b) + random.power_of_ten(-20, -14) * random.in_cube();
  return sample;
}

TEST(AreaRatioMapStability, HoldsEightStepsOfTheConditioningWhereTheAreaIsLostInItsRounding) {
  int lost = 0;
  for (std::uint64_t number = 0; number < SWEEPKIT_MAP_PAIRS; ++number) {
    const MapCase<double> sample = area_in_its_rounding(number);
    const auto plane = dominant_plane(sample.triangle);
    lost += plane.area2 == 0 ? 1 : 0;
    const ExactMap exact = exact_map(sample, plane.i, plane.j);
    if (!exact.has_area) continue;
    const glm::dvec2 uv = kTexture.b + glm::dvec2(static_cast<double>(exact.c) * kTexture.bc,
                                                  static_cast<double>(exact.a) * kTexture.ba);
    const Bound bound = bound_of<double>(exact, uv);
    for (const auto& mapped : {map_once<AreaRatioMap>(sample.triangle, kTexture, sample.hit),
                               area_ratio_map(sample.triangle, kTexture, sample.hit)}) {
      ASSERT_LE(std::abs(static_cast<double>(kTexture.b.x + exact.c * kTexture.bc - mapped.x)), bound.u)
          << number;
      ASSERT_LE(std::abs(static_cast<double>(kTexture.b.y + exact.a * kTexture.ba - mapped.y)), bound.v)
          << number;
    }
  }
  // Both sides of the choice were looked at.
  EXPECT_GT(lost, SWEEPKIT_MAP_PAIRS / 10);
  EXPECT_LT(lost, SWEEPKIT_MAP_PAIRS - SWEEPKIT_MAP_PAIRS / 10);
}

TEST_P(AreaRatioMapHard, HoldsEightStepsOfTheConditioningInDouble) {
  expect_promise<double>(static_cast<Hardness>(GetParam()));
}

TEST_P(AreaRatioMapHard, HoldsEightStepsOfTheConditioningInFloat) {
  expect_promise<float>(static_cast<Hardness>(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Stability, AreaRatioMapHard,
                         testing::Range(0, static_cast<int>(kHardnessNames.size())), [](const auto& kind) {
                           std::string name(kHardnessNames[static_cast<std::size_t>(kind.param)]);
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

}  // namespace
}  // namespace sweepkit::texmap
