// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "adversarial_triangles.hpp"
#include "counting_number.hpp"
#include "sweepkit/texmap/triangle_maps.hpp"

namespace sweepkit::texmap {
namespace {

const RightTriangle kUnit{{0, 0}, 1, 1};

// A triangle and a hit with barycentric coordinates (a, b, c), b up to `largest_b`.
MapCase<float> random_case(std::mt19937& random, double largest_b) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto point = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  const glm::dvec3 a = point();
  const glm::dvec3 b = point();
  const glm::dvec3 c = point();
  const double wb = largest_b * unit(random);
  const double wa = (1 - wb) * unit(random);
  return {{glm::vec3(a), glm::vec3(b), glm::vec3(c)}, glm::vec3(wa * a + wb * b + (1 - wa - wb) * c)};
}

double error_of(const glm::vec2& mapped, const MapCase<float>& sample) {
  const auto plane = dominant_plane(sample.triangle);
  const ExactMap exact = exact_map(sample, plane.i, plane.j);
  return std::max(std::abs(static_cast<double>(mapped.x - exact.c)),
                  std::abs(static_cast<double>(mapped.y - exact.a)));
}

template <class Real, class From>
Triangle3<Real> converted(const Triangle3<From>& t) {
  using Vec = glm::vec<3, Real>;
  return {Vec(t.a), Vec(t.b), Vec(t.c)};
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

// Runs `check.operator()<Map>()` for every method.
template <class Check>
void for_each_map(Check&& check) {
  const auto run = [&]<class... Maps>(std::tuple<Maps...>) { (check.template operator()<Maps>(), ...); };
  run(TriangleMaps{});
}

const Triangle3<double> kTriangle{{1, 2, 3}, {4, 0, 1}, {2, 5, -1}};

TEST(TriangleMaps, TakeCornersToCorners) {
  const RightTriangle right = right_triangle({0.2, 0.9}, {0.2, 0.1}, {0.8, 0.1});
  const glm::dvec2 corners[] = {{0.2, 0.9}, {0.2, 0.1}, {0.8, 0.1}};
  const glm::dvec3 from[] = {kTriangle.a, kTriangle.b, kTriangle.c};
  const auto check = [&]<class Map>() {
    for (int k = 0; k < 3; ++k) {
      // A1 is the doubled vertex, where that map has no value, and C1 a corner that the paper forgot.
      if (std::is_same_v<Map, DoubledVertexMap> && k == 0) continue;
      if (std::is_same_v<Map, CevianMap> && k == 2) continue;
      // A few hundred roundings of 1e-16: the coordinates are up to 5, the triangle's height 4.
      EXPECT_LT(glm::length(map_once<Map>(kTriangle, right, from[k]) - corners[k]), 1e-13)
          << Map::kName << " " << k;
    }
  };
  for_each_map(check);
  EXPECT_EQ(area_ratio_map(right, 1, 0), corners[0]);
  EXPECT_EQ(area_ratio_map(right, 0, 0), corners[1]);
  EXPECT_EQ(area_ratio_map(right, 0, 1), corners[2]);
}

TEST(TriangleMaps, AreTheAffineMapInQuadruplePrecisionExceptTheDoubledVertex) {
  const RightTriangle right{{0.25, -3}, -0.5, 2};
  const Triangle3<Quad> t = converted<Quad>(kTriangle);
  const auto check = [&]<class Map>() {
    static_assert(TriangleMap<Map, float> && TriangleMap<Map, double> && TriangleMap<Map, Quad> &&
                  TriangleMap<Map, CountingNumber>);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.1, 1);
    for (int n = 0; n < 100; ++n) {
      Quad a = unit(random);
      Quad b = unit(random);
      Quad c = unit(random);
      const Quad sum = a + b + c;
      a /= sum;
      b /= sum;
      c /= sum;
      const glm::vec<3, Quad> hit = t.a * a + t.b * b + t.c * c;
      const bool is_doubled = std::is_same_v<Map, DoubledVertexMap>;
      const Quad u = 0.25 - 0.5 * (is_doubled ? c / (b + c) : c);
      const Quad v = -3 + 2 * a;
      const glm::vec<2, Quad> mapped = map_once<Map>(t, right, hit);
      // Quadruple precision has 2e-34; a derivation that is wrong is wrong by far more than 1e-30.
      EXPECT_LT(std::abs(static_cast<double>(mapped.x - u)), 1e-30) << Map::kName;
      EXPECT_LT(std::abs(static_cast<double>(mapped.y - v)), 1e-30) << Map::kName;
    }
  };
  for_each_map(check);
}

TEST(TriangleMaps, KeepTheCentroidExceptTheDoubledVertex) {
  const RightTriangle right = right_triangle({0.2, 0.9}, {0.2, 0.1}, {0.8, 0.1});
  for (const CentroidError& error : centroid_errors(kTriangle, right)) {
    // Half the row that the centroid lies in, instead of a third of the leg: a sixth of it off.
    const double expected = error.method == DoubledVertexMap::kName ? 0.6 / 6 : 0;
    EXPECT_NEAR(error.distance, expected, 1e-14) << error.method;
  }
}

struct Cost {
  std::string_view method;
  OperationCounts prepare, map;
};

Cost cost_of(std::string_view method) {
  const auto t = converted<CountingNumber>(kTriangle);
  const glm::vec<3, CountingNumber> hit(
      glm::dvec3(0.5 * kTriangle.a + 0.2 * kTriangle.b + 0.3 * kTriangle.c));
  Cost cost{method, {}, {}};
  for_each_map([&]<class Map>() {
    if (Map::kName != method) return;
    typename Map::template Prepared<CountingNumber> prepared;
    cost.prepare = count_operations([&] { prepared = Map::prepare(t, kUnit); });
    cost.map = count_operations([&] { Map::map(prepared, t, kUnit, hit); });
  });
  return cost;
}

TEST(TriangleMaps, CostWhatTheirHeadersSay) {
  struct Expected {
    std::string_view method;
    int prepare, map, square_roots;
  };
  // Prepared: by hand from the formulas; area ratios and barycentric spend 7 on the choice of plane.
  for (const Expected& expected :
       {Expected{"barycentric", 22, 12, 0}, Expected{"doubled-vertex", 47, 16, 1},
        Expected{"matrix", 33, 6, 0}, Expected{"cevian", 0, 15, 0}, Expected{"area-ratio", 11, 6, 0}}) {
    const Cost cost = cost_of(expected.method);
    EXPECT_EQ(cost.prepare.products(), expected.prepare) << expected.method;
    EXPECT_EQ(cost.map.products(), expected.map) << expected.method;
    EXPECT_EQ(cost.map.square_roots, expected.square_roots) << expected.method;
  }
}

TEST(AreaRatioMap, NeedsNoMoreProductsThanThePapersSixteen) {
  const auto t = converted<CountingNumber>(kTriangle);
  const glm::vec<3, CountingNumber> hit(glm::dvec3(1.5, 2, 1));
  const OperationCounts counts = count_operations([&] { area_ratio_map(t, kUnit, hit); });
  EXPECT_EQ(counts.multiplications, 13);
  EXPECT_EQ(counts.divisions, 2);
}

TEST(AreaRatioMap, IsTheSamePreparedOrNotUpToRounding) {
  std::mt19937 random(1);
  for (int n = 0; n < 1000; ++n) {
    const MapCase<float> sample = random_case(random, 0.5);
    const glm::vec2 once = area_ratio_map(sample.triangle, kUnit, sample.hit);
    // Both work in double; they may round to neighbouring floats.
    EXPECT_LE(glm::length(map_once<AreaRatioMap>(sample.triangle, kUnit, sample.hit) - once), 1.2e-7f);
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
    const MapCase<float> sample = random_case(random, largest_b);
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
  const auto paper = [](const MapCase<float>& s) { return map_once<CevianMap>(s.triangle, kUnit, s.hit); };
  const auto stable = [](const MapCase<float>& s) { return area_ratio_map(s.triangle, kUnit, s.hit); };
  // The order of magnitude in which eq. 9 loses its figures: 1e-8 anywhere, 1e-4 at b to 1e-4, all at b to
  // 1e-7.
  EXPECT_LT(failures(1, paper).median, 1e-6);
  EXPECT_GT(failures(1e-4, paper).median, 1e-5);
  EXPECT_GT(failures(1e-7, paper).median, 1e-2);
  // Without eq. 10-11 for hits on A1C1 eq. 9 is 0/0 wherever both ratios round to 1: a tenth of the hits at b
  // to 1e-7.
  const auto without_special_case = [](const MapCase<float>& s) {
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
  EXPECT_FALSE(std::isfinite(map_once<CevianMap>(t, kUnit, hit).x));
  EXPECT_LT(glm::length(area_ratio_map(t, kUnit, hit) - glm::dvec2(0.25, 0.25)), 1e-15);
}

TEST(CevianMap, HasNoValueAtC1) {
  // The paper takes care of H1 = A1, where r_BC is 0/0, and not of C1, where r_BA is.
  EXPECT_TRUE(std::isnan(map_once<CevianMap>(kTriangle, kUnit, kTriangle.c).y));
  EXPECT_EQ(map_once<CevianMap>(kTriangle, kUnit, kTriangle.a), glm::dvec2(0, 1));
}

TEST(MatrixMap, HasNoValueOnAPlaneThroughTheOrigin) {
  const Triangle3<double> floor{{0, 0, -1}, {0, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(std::isfinite(map_once<MatrixMap>(floor, kUnit, {0.25, 0, -0.5}).x));
  EXPECT_EQ(map_once<AreaRatioMap>(floor, kUnit, {0.25, 0, -0.5}), glm::dvec2(0.25, 0.5));
}

TEST(BarycentricMap, LosesTheDigitsThatTheDistanceFromTheOriginTakes) {
  // 2^20 leaves a float 3 bits behind the point, which are enough for these corners and this hit. The terms
  // of eq. 2 come to 2^41 and cancel down to 1: nothing is left of 24 bits, and the determinant may be 0.
  const glm::vec3 away(0x1p20f);
  const Triangle3<float> t{away + glm::vec3(0, 1, 0), away, away + glm::vec3(1, 0, 0)};
  const glm::vec3 hit = away + glm::vec3(0.25f, 0.5f, 0);
  EXPECT_FALSE(glm::length(map_once<BarycentricMap>(t, kUnit, hit) - glm::vec2(0.25f, 0.5f)) < 0.1f);
  EXPECT_EQ(map_once<AreaRatioMap>(t, kUnit, hit), glm::vec2(0.25f, 0.5f));
}

TEST(DoubledVertexMap, LosesHalfTheDigitsAtTheDoubledVertexAndAllOnIt) {
  const auto at = [&](double a) { return a * kTriangle.a + 0.5 * (1 - a) * (kTriangle.b + kTriangle.c); };
  EXPECT_FALSE(std::isfinite(map_once<DoubledVertexMap>(kTriangle, kUnit, kTriangle.a).x));
  double largest = 0;
  for (int n = 1; n <= 100; ++n) {
    const double a = 1 - 1e-9 * n;
    const double error = std::abs(map_once<DoubledVertexMap>(kTriangle, kUnit, at(a)).y - a);
    if (std::isfinite(error)) largest = std::max(largest, error);
    EXPECT_NEAR(map_once<AreaRatioMap>(kTriangle, kUnit, at(a)).y, a, 1e-15);
  }
  // The root of 2^-53 is 1e-8.
  EXPECT_GT(largest, 1e-9);
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
  const RightTriangle right{{0.3, 0.4}, 1, 1};
  const Triangle3<double> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  EXPECT_EQ(area_ratio_map<double>(line, right, {1, 1, 1}), right.b);
  EXPECT_EQ(map_once<AreaRatioMap>(line, right, {1, 1, 1}), right.b);
  // Too small and too large for products in double.
  for (const double size : {1e-150, 1e160}) {
    const Triangle3<double> t{{0, size, 0}, {0, 0, 0}, {size, 0, 0}};
    EXPECT_EQ(area_ratio_map<double>(t, right, {size / 4, size / 4, 0}), right.b) << size;
  }
  // The sizes that the header promises.
  for (const double size : {1e-100, 1e140}) {
    const Triangle3<double> t{{0, size, 0}, {0, 0, 0}, {size, 0, 0}};
    EXPECT_LT(glm::length(area_ratio_map<double>(t, kUnit, {size / 4, size / 4, 0}) - 0.25), 1e-15) << size;
  }
}

TEST(Mappings, CentroidErrorsOfASurfaceAreMeansOverItsRightTriangles) {
  // A square floor at y = 0 of two triangles, and one whose (u,v) are no right triangle.
  const std::vector<glm::vec3> positions = {{0, 0, -1}, {0, 0, 0}, {1, 0, 0}, {1, 0, -1}};
  const std::vector<glm::vec2> texcoords = {{0, 1}, {0, 0}, {1, 0}, {1, 1}};
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {2, 3, 0}, {1, 2, 0}};
  const auto all = summarize_centroid_errors({positions, texcoords, triangles});
  for (const CentroidErrors& errors : all) {
    SCOPED_TRACE(errors.method);
    if (errors.method == MatrixMap::kName) {
      EXPECT_EQ(errors.failures, 2u);  // the plane holds the origin: eq. 3 has no inverse
    } else {
      EXPECT_EQ(errors.failures, 0u);
      // (1/2, 1/3) in place of (1/3, 1/3) of the legs.
      EXPECT_NEAR(errors.mean, errors.method == DoubledVertexMap::kName ? 1.0 / 6 : 0, 1e-15);
      EXPECT_NEAR(errors.worst, errors.mean, 1e-15);
    }
  }
  EXPECT_TRUE(
      summarize_centroid_errors({positions, texcoords, std::span(triangles).last(1)}).front().method.empty());
}

}  // namespace
}  // namespace sweepkit::texmap
