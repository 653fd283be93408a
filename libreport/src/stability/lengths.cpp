// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <numbers>

#include "quad.hpp"
#include "stability/stability_case.hpp"
#include "sweepkit/sweep/primitives.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kStage = "lengths";
constexpr const char* kPromise = "arc length: relative error below 1e-9";
constexpr double kBound = 1e-9;

double relative(double length, Quad exact) {
  return static_cast<double>(fabsq(length - exact) / exact);
}

// (t, t^2 / 2w), t in [-1, 1]: its length is w (u sqrt(1 + u^2) + asinh u), u = 1 / w.
StabilityCase kink(double width, const std::string& power) {
  return {.name = "lengths_kink_" + power,
          .stage = kStage,
          .input = "parabola whose speed has a kink " + power + " times as wide as the parameter",
          .hardness = 1 / width,
          .hardness_is = "parameter over the kink's width",
          .promise = kPromise,
          .unit = "relative",
          .run = [width] {
            const double rise = 1 / (2 * width);
            // The rise as it was rounded: 2 rise t^2 - rise.
            const Quad w = 1 / (2 * static_cast<Quad>(rise));
            const Quad v = 1 / w;
            return Reached{
                .error = relative(sweep::bezier_curve<2>({{-1, rise}, {0, -rise}, {1, rise}}).length(),
                                  w * (v * sqrtq(1 + v * v) + asinhq(v))),
                .bound = kBound};
          }};
}

// A quarter by Gauss's arithmetic-geometric mean: exact to the last bits for every thinness.
Quad ellipse_length(Quad a, Quad b) {
  Quad x = a;
  Quad y = b;
  Quad sum = (a * a + b * b) / 2;
  Quad power = static_cast<Quad>(0.5);
  for (int i = 0; i < 60 && fabsq(x - y) > static_cast<Quad>(1e-30) * x; ++i) {
    const Quad c = (x - y) / 2;
    const Quad next = (x + y) / 2;
    y = sqrtq(x * y);
    x = next;
    power *= 2;
    sum -= power * c * c;
  }
  return 2 * quad_pi() * sum / x;
}

StabilityCase needle(double thin, const std::string& power) {
  return {.name = "lengths_needle_" + power,
          .stage = kStage,
          .input = "ellipse " + power + " times as wide as long",
          .hardness = 1 / thin,
          .hardness_is = "length over width",
          .promise = kPromise,
          .unit = "relative",
          .run = [thin] {
            return Reached{
                .error = relative(sweep::ellipse_contour(1, thin).length(), ellipse_length(1, thin)),
                .bound = kBound};
          }};
}

StabilityCase spans(int count, const std::string& power) {
  return {.name = "lengths_spans_" + power,
          .stage = kStage,
          .input = power + " straight spans",
          .hardness = static_cast<double>(count),
          .hardness_is = "spans",
          .promise = kPromise,
          .unit = "relative",
          .run = [count] {
            std::vector<glm::dvec2> points;
            Quad exact = 0;
            for (int i = 0; i <= count; ++i) {
              points.push_back({0.1 * i, i % 2 == 0 ? 0.0 : 0.7});
              if (i == 0) continue;
              const glm::dvec2& from = points[points.size() - 2];
              const glm::dvec2& to = points.back();
              exact += hypotq(static_cast<Quad>(to.x) - from.x, static_cast<Quad>(to.y) - from.y);
            }
            float in_float = 0;
            for (std::size_t i = 1; i < points.size(); ++i)
              in_float += glm::distance(glm::vec2(points[i - 1]), glm::vec2(points[i]));
            const double error = relative(sweep::polyline<2>(points, false).length(), exact);
            return Reached{
                .error = error, .bound = kBound, .in_float = relative(static_cast<double>(in_float), exact)};
          }};
}

// Half the way round a needle is its other tip.
StabilityCase found_again(double thin, const std::string& power) {
  return {.name = "lengths_located_" + power,
          .stage = kStage,
          .input = "the place half way round an ellipse " + power + " times as wide as long",
          .hardness = 1 / thin,
          .hardness_is = "length over width",
          .promise = kPromise,
          .unit = "of the length",
          .run = [thin] {
            const sweep::Curve2 curve = sweep::ellipse_contour(1, thin);
            const glm::dvec2 place = curve.evaluate(curve.locate(0.5 * curve.length())).position;
            return Reached{.error = glm::distance(place, {-1, 0}) / curve.length(), .bound = kBound};
          }};
}

}  // namespace

std::vector<StabilityCase> length_stability_cases() {
  return {kink(1e-1, "1e_1"),   kink(1e-3, "1e_3"),        kink(1e-6, "1e_6"),       kink(1e-9, "1e_9"),
          needle(1e-3, "1e_3"), needle(1e-6, "1e_6"),      needle(1e-9, "1e_9"),     spans(1000, "1e3"),
          spans(100000, "1e5"), found_again(1e-3, "1e_3"), found_again(1e-6, "1e_6")};
}

}  // namespace sweepkit::report
