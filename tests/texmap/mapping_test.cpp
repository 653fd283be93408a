// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sweepkit/texmap/area_ratio_mapping.hpp"
#include "sweepkit/texmap/cevian_mapping.hpp"

namespace sweepkit::texmap {
namespace {

__extension__ using Quad = __float128;

const RightTriangle kUnit{{0, 0}, 1, 1};

struct Case {
  Triangle3<float> triangle;
  glm::vec3 hit;
};

// A triangle and a hit with barycentric coordinates (a, b, c), b up to `largest_b`.
Case random_case(std::mt19937& random, double largest_b) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto point = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  const glm::dvec3 a = point();
  const glm::dvec3 b = point();
  const glm::dvec3 c = point();
  const double wb = largest_b * unit(random);
  const double wa = (1 - wb) * unit(random);
  return {{glm::vec3(a), glm::vec3(b), glm::vec3(c)}, glm::vec3(wa * a + wb * b + (1 - wa - wb) * c)};
}

glm::vec<2, Quad> exact_map(const Case& sample) {
  // The definition, |B2Y| = c |B2C2| and |B2X| = a |B2A2| by areas of the projection, with 113 bits.
  const auto quad = [](const glm::vec3& p) { return glm::vec<3, Quad>(p.x, p.y, p.z); };
  return area_ratio_map<Quad>({quad(sample.triangle.a), quad(sample.triangle.b), quad(sample.triangle.c)},
                              kUnit, quad(sample.hit));
}

double error_of(const glm::vec2& mapped, const Case& sample) {
  const glm::vec<2, Quad> exact = exact_map(sample);
  return std::max(std::abs(static_cast<double>(mapped.x - exact.x)),
                  std::abs(static_cast<double>(mapped.y - exact.y)));
}

TEST(RightTriangle, SubdivisionCoversTheTextureOnce) {
  const RightTriangleSubdivision grid{3, 5};
  double area = 0;
  for (std::uint32_t i = 0; i < grid.triangle_count(); ++i) {
    const RightTriangle t = grid.triangle(i);
    EXPECT_GT(t.bc * t.ba, 0);
    area += 0.5 * t.bc * t.ba;
  }
  EXPECT_NEAR(area, 1, 1e-14);
  EXPECT_EQ(grid.triangle(0).b, glm::dvec2(0, 0));
  EXPECT_EQ(grid.triangle(29).b, glm::dvec2(1, 1));
}

TEST(Mappings, TakeCornersToCornersAndKeepTheCentroid) {
  const Triangle3<double> t{{1, 2, 3}, {4, 0, 1}, {2, 5, -1}};
  const RightTriangle right = right_triangle({0.2, 0.9}, {0.2, 0.1}, {0.8, 0.1});
  const glm::dvec3 centroid = (t.a + t.b + t.c) / 3.0;
  const auto expect = [](const glm::dvec2& got, const glm::dvec2& want) {
    EXPECT_LT(glm::length(got - want), 1e-14);
  };
  expect(area_ratio_map(t, right, t.a), {0.2, 0.9});
  expect(area_ratio_map(t, right, t.b), {0.2, 0.1});
  expect(area_ratio_map(t, right, t.c), {0.8, 0.1});
  expect(area_ratio_map(t, right, centroid), glm::dvec2(1.2, 1.1) / 3.0);
  expect(cevian_map(t, right, centroid), glm::dvec2(1.2, 1.1) / 3.0);
  expect(cevian_map(t, right, t.a), {0.2, 0.9});
  expect(barycentric_map(right, 1.0 / 3, 1.0 / 3), glm::dvec2(1.2, 1.1) / 3.0);
}

TEST(Mappings, AgreeOnOrdinaryHits) {
  std::mt19937 random(1);
  for (int n = 0; n < 1000; ++n) {
    const Case sample = random_case(random, 0.5);
    const auto wide = [](const glm::vec3& p) { return glm::dvec3(p); };
    const Triangle3<double> t{wide(sample.triangle.a), wide(sample.triangle.b), wide(sample.triangle.c)};
    const glm::dvec2 stable = area_ratio_map(t, kUnit, wide(sample.hit));
    const glm::dvec2 paper = cevian_map(t, kUnit, wide(sample.hit));
    // float32 hits lie off the triangle's plane by 1e-7; the maps project differently and thin triangles
    // enlarge that.
    const double thinness = glm::length(glm::cross(t.a - t.b, t.c - t.b));
    EXPECT_LT(glm::length(stable - paper), 1e-6 / (thinness * thinness) / 0.01) << n;
  }
}

// What the paper's formula does near the hypotenuse and the stable one does not.
struct Failures {
  int not_finite = 0;
  double median = 0;
  double largest = 0;
};
template <class Map>
Failures failures(double largest_b, Map&& map) {
  std::mt19937 random(2);
  std::vector<double> errors;
  Failures result;
  for (int n = 0; n < 20000; ++n) {
    const Case sample = random_case(random, largest_b);
    const double error = error_of(map(sample), sample);
    if (!std::isfinite(error)) {
      ++result.not_finite;
    } else {
      errors.push_back(error);
    }
  }
  std::sort(errors.begin(), errors.end());
  result.median = errors[errors.size() / 2];
  result.largest = errors.back();
  return result;
}

TEST(CevianMap, FailsNearTheHypotenuseWhereTheStableMapDoesNot) {
  const auto paper = [](const Case& s) { return cevian_map(s.triangle, kUnit, s.hit); };
  const auto stable = [](const Case& s) { return area_ratio_map(s.triangle, kUnit, s.hit); };
  // The order of magnitude in which eq. 9 loses its figures: 1e-8 anywhere, 1e-4 at b to 1e-4, all at b to
  // 1e-7.
  EXPECT_LT(failures(1, paper).median, 1e-6);
  EXPECT_GT(failures(1e-4, paper).median, 1e-5);
  EXPECT_GT(failures(1e-7, paper).median, 1e-2);
  // Without eq. 10-11 for hits on A1C1 eq. 9 is 0/0 wherever both ratios round to 1: a tenth of the hits at b
  // to 1e-7.
  const auto without_special_case = [](const Case& s) {
    const float r_bc = cevian::ratio(s.triangle.a, s.triangle.b, s.triangle.c, s.hit, 0, 1);
    const float r_ba = cevian::ratio(s.triangle.c, s.triangle.b, s.triangle.a, s.hit, 0, 1);
    return glm::vec2((r_bc * r_ba - r_bc) / (r_bc * r_ba - 1), (r_bc * r_ba - r_ba) / (r_bc * r_ba - 1));
  };
  EXPECT_GT(failures(1e-7, without_special_case).not_finite, 200);
  for (const double b : {1.0, 1e-4, 1e-7}) {
    const Failures f = failures(b, stable);
    EXPECT_EQ(f.not_finite, 0);
    EXPECT_LT(f.median, 1e-7);
  }
}

TEST(CevianMap, ItsChoiceOfPlaneFailsOnPlanesThatContainZ) {
  // The plane x = y is neither an x-plane nor a y-plane, and seen along z it is a line: eq. 8 is 0/0 there.
  const Triangle3<double> t{{0, 0, 1}, {0, 0, 0}, {1, 1, 0}};
  const glm::dvec3 hit(0.25, 0.25, 0.25);
  EXPECT_FALSE(std::isfinite(cevian_map(t, kUnit, hit).x));
  EXPECT_LT(glm::length(area_ratio_map(t, kUnit, hit) - glm::dvec2(0.25, 0.25)), 1e-15);
}

TEST(AreaRatioMap, WorksOnEveryAxisPlaneAndThroughTheOrigin) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double height : {0.0, 5.0}) {
      glm::dvec3 a(height);
      glm::dvec3 b(height);
      glm::dvec3 c(height);
      b[(axis + 1) % 3] = b[(axis + 2) % 3] = 0;
      a = b;
      c = b;
      a[(axis + 1) % 3] = 2;
      c[(axis + 2) % 3] = 3;
      const glm::dvec2 mapped = area_ratio_map<double>({a, b, c}, kUnit, 0.5 * a + 0.25 * b + 0.25 * c);
      EXPECT_LT(glm::length(mapped - glm::dvec2(0.25, 0.5)), 1e-15);
    }
  }
}

TEST(AreaRatioMap, GivesATriangleWithoutAreaItsRightAngle) {
  const Triangle3<double> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  EXPECT_EQ(area_ratio_map<double>(line, {{0.3, 0.4}, 1, 1}, {1, 1, 1}), glm::dvec2(0.3, 0.4));
}

}  // namespace
}  // namespace sweepkit::texmap
