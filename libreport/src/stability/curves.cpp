// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Symbols: B a Bezier segment of degree n with control points p_k; against de Casteljau in quadruple
// precision.

#include "sweepkit/sweep/curve.hpp"

#include <array>

#include "quad.hpp"
#include "stability/stability_case.hpp"
#include "sweepkit/sweep/primitives.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kStage = "curves";
constexpr const char* kDouble = "positions, frames, arc length: double inside";
constexpr const char* kFinite = "finite at poles, cusps and zero-area places";

template <class Real>
using Point = std::array<Real, 2>;

template <class Real>
Point<Real> de_casteljau(std::vector<Point<Real>> p, Real t) {
  for (std::size_t left = p.size() - 1; left > 0; --left) {
    for (std::size_t k = 0; k < left; ++k) {
      for (std::size_t i = 0; i < 2; ++i) p[k][i] = (1 - t) * p[k][i] + t * p[k + 1][i];
    }
  }
  return p[0];
}

template <class Real>
std::vector<Point<Real>> as(const std::vector<glm::dvec2>& control) {
  std::vector<Point<Real>> points;
  for (const glm::dvec2& p : control) points.push_back({static_cast<Real>(p.x), static_cast<Real>(p.y)});
  return points;
}

std::vector<Point<Quad>> differences(const std::vector<Point<Quad>>& p) {
  std::vector<Point<Quad>> steps;
  for (std::size_t k = 1; k < p.size(); ++k) steps.push_back({p[k][0] - p[k - 1][0], p[k][1] - p[k - 1][1]});
  return steps;
}

double length(const Point<Quad>& p) {
  return static_cast<double>(sqrtq(p[0] * p[0] + p[1] * p[1]));
}

double angle(const glm::dvec2& direction, const Point<Quad>& exact) {
  return static_cast<double>(fabsq(atan2q(direction.x * exact[1] - direction.y * exact[0],
                                          direction.x * exact[0] + direction.y * exact[1])));
}

// Control points at +-size but for the first and last: sums of large terms that leave little.
StabilityCase alternating(double size, const std::string& name) {
  constexpr int kDegree = 32;
  std::vector<glm::dvec2> control;
  for (int k = 0; k <= kDegree; ++k) {
    const bool is_end = k == 0 || k == kDegree;
    control.push_back({static_cast<double>(k) / kDegree, is_end ? 1.0 : k % 2 == 0 ? size : -size});
  }
  return {.name = name,
          .stage = kStage,
          .input = "degree 32, control points alternate between +-" + name.substr(name.rfind('_') + 1),
          .hardness = size,
          .hardness_is = "largest control point over the curve's ends",
          .promise = kDouble,
          .unit = "m",
          .run = [control, size] {
            Reached reached;
            double in_float = 0;
            // At every level (1 - t), two products and a sum: 3 roundings of a convex combination.
            reached.bound = 3 * kDegree * kRounding * size;
            for (int i = 0; i <= 64; ++i) {
              const double t = i / 64.0;
              const Point<Quad> exact = de_casteljau(as<Quad>(control), static_cast<Quad>(t));
              const glm::dvec2 here = sweep::evaluate<2>(sweep::BezierSegment<2>{control}, t).position;
              reached.error = worse(reached.error, length({here.x - exact[0], here.y - exact[1]}));
              const Point<float> narrow = de_casteljau(as<float>(control), static_cast<float>(t));
              in_float = worse(in_float, length({narrow[0] - exact[0], narrow[1] - exact[1]}));
            }
            reached.in_float = in_float;
            return reached;
          }};
}

// Beside the cusp of a cubic its derivative is the small difference of large ones.
StabilityCase beside_cusp(double beside, const std::string& name) {
  const std::vector<glm::dvec2> control = {{0, 0}, {1, 1}, {0, 1}, {1, 0}};
  const double t = 0.5 + beside;
  const Point<Quad> exact = de_casteljau(differences(as<Quad>(control)), static_cast<Quad>(t));
  const double hardness = 1 / length(exact);
  return {.name = name,
          .stage = kStage,
          .input = "cubic with a cusp at t = 1/2, tangent at 1/2 + " + name.substr(name.rfind('_') + 1),
          .hardness = hardness,
          .hardness_is = "speed of the control polygon over the curve's",
          .promise = kFinite,
          .unit = "rad",
          .run = [control, t, exact, hardness] {
            // 3 roundings a level over 3 levels, of terms no longer than sqrt(2).
            return Reached{.error = angle(sweep::tangent<2>(sweep::BezierSegment<2>{control}, t), exact),
                           .bound = 9 * std::sqrt(2.0) * kRounding * hardness};
          }};
}

StabilityCase repeated(int count) {
  return {
      .name = "curves_repeated_points_" + std::to_string(count),
      .stage = kStage,
      .input = std::to_string(count) + " equal control points at the start, then two more: the tangent there",
      .hardness = static_cast<double>(count),
      .hardness_is = "derivatives that vanish, and one",
      .promise = kFinite,
      .unit = "rad",
      .run = [count] {
        std::vector<glm::dvec2> control(static_cast<std::size_t>(count), {0.1, 0.3});
        control.insert(control.end(), {{1.1, 2.3}, {4, -1}});
        const Quad x = static_cast<Quad>(1.1) - static_cast<Quad>(0.1);
        const Quad y = static_cast<Quad>(2.3) - static_cast<Quad>(0.3);
        // Two differences, a length of three operations, a quotient.
        return Reached{.error = angle(sweep::tangent<2>(sweep::BezierSegment<2>{control}, 0), {x, y}),
                       .bound = 8 * kRounding};
      }};
}

// (t, t^2 / 2w), t in [-1, 1], of curvature 1/w at its vertex.
StabilityCase bend(double width, const std::string& name) {
  const double rise = 1 / (2 * width);
  const std::vector<glm::dvec2> control = {{-1, rise}, {0, -rise}, {1, rise}};
  return {
      .name = name,
      .stage = kStage,
      .input = "parabola of curvature " + name.substr(name.rfind('_') + 1) + "/m, tangents about its vertex",
      .hardness = std::max(1 / width, width),
      .hardness_is = "curvature times 1 m, or the inverse",
      .promise = kFinite,
      .unit = "rad",
      .run = [control, width] {
        Reached reached;
        // The derivative is the mean of two differences of the size 1/w: 5 roundings of it, against 1.
        reached.bound = 5 * kRounding * std::max(1.0, 1 / width);
        for (int i = -8; i <= 8; ++i) {
          const double t = 0.5 + 0.5 * std::min(width, 1.0) * i / 8;
          const Point<Quad> exact = de_casteljau(differences(as<Quad>(control)), static_cast<Quad>(t));
          reached.error =
              worse(reached.error, angle(sweep::tangent<2>(sweep::BezierSegment<2>{control}, t), exact));
        }
        return reached;
      }};
}

StabilityCase helix_turns(double turns, const std::string& name) {
  return {.name = name,
          .stage = kStage,
          .input = "helix of " + name.substr(name.rfind('_') + 1) + " turns, points all along it",
          .hardness = turns,
          .hardness_is = "turns",
          .promise = kDouble,
          .unit = "m",
          .run = [turns] {
            Reached reached;
            double in_float = 0;
            const sweep::Curve3 curve = sweep::helix(1, 0.1, turns);
            // The angle's product and the fold to one turn are rounded, and its cosine.
            reached.bound = 4 * kRounding * 2 * static_cast<double>(quad_pi()) * turns;
            for (int i = 0; i <= 1000; ++i) {
              const double t = i / 1000.0;
              const Quad a = 2 * quad_pi() * turns * static_cast<Quad>(t);
              const glm::dvec3 p = curve.evaluate({0, t}).position;
              reached.error = worse(reached.error, static_cast<double>(hypotq(p.x - cosq(a), p.z + sinq(a))));
              const float narrow = 6.2831853F * static_cast<float>(turns) * static_cast<float>(t);
              in_float =
                  worse(in_float,
                        static_cast<double>(hypotq(std::cos(narrow) - cosq(a), std::sin(narrow) - sinq(a))));
            }
            reached.in_float = in_float;
            return reached;
          }};
}

StabilityCase uneven_free_curve() {
  return {.name = "curves_free_uneven_1e9",
          .stage = kStage,
          .input = "smooth curve, a span of 1 m between two of 1e-9 m",
          .hardness = 1e9,
          .hardness_is = "longer over shorter span",
          .promise = "a smooth curve departs from a chord by at most 3/4 of its longer handle",
          .unit = "m",
          .run = [] {
            const sweep::Curve2 curve = sweep::free_curve<2>({{0, -1e-9}, {0, 0}, {1, 0}, {1, 1e-9}}, false);
            Reached reached{.bound = 0.75e-9};
            // Both handles of the long span are no longer than the short ones.
            for (int i = 0; i <= 256; ++i)
              reached.error = worse(reached.error, std::abs(curve.evaluate({1, i / 256.0}).position.y));
            return reached;
          }};
}

}  // namespace

std::vector<StabilityCase> curve_cases() {
  return {alternating(1e4, "curves_degree_32_1e4"),
          alternating(1e8, "curves_degree_32_1e8"),
          alternating(1e12, "curves_degree_32_1e12"),
          beside_cusp(1e-3, "curves_beside_cusp_1e_3"),
          beside_cusp(1e-6, "curves_beside_cusp_1e_6"),
          beside_cusp(0x1p-40, "curves_beside_cusp_2e_40"),
          repeated(3),
          repeated(30),
          bend(1e-3, "curves_bend_1e3"),
          bend(1e-9, "curves_bend_1e9"),
          bend(1e9, "curves_bend_1e_9"),
          helix_turns(1e2, "curves_helix_1e2"),
          helix_turns(1e5, "curves_helix_1e5"),
          uneven_free_curve()};
}

}  // namespace sweepkit::report
