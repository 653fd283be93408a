// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// [Schumaker86] L. Schumaker, W. Volk, "Efficient evaluation of multivariate polynomials" (1986): the
// Horner-like form. [Jiang10] H. Jiang, S. Li, L. Cheng, F. Su, "Accurate evaluation of a polynomial and its
// derivative in Bernstein form" (2010): the compensated form, as exact as de Casteljau in twice the
// precision.
//
// Symbols: b control point, t parameter, s = 1 - t, e what rounding left out.

#include "bezier_methods.hpp"

#include <algorithm>
#include <array>

namespace sweepkit::report {
namespace {

using Control = std::span<const glm::dvec3>;
using Parameters = std::span<const double>;
using Points = std::span<glm::dvec3>;

constexpr std::size_t kMostPoints = 64;
using Level = std::array<glm::dvec3, kMostPoints>;

glm::dvec3 de_casteljau(Control control, double t) {
  Level b;
  std::copy(control.begin(), control.end(), b.begin());
  for (std::size_t left = control.size() - 1; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) b[i] = (1 - t) * b[i] + t * b[i + 1];
  }
  return b[0];
}

// The sum of binomial(n, i) b[i] u^i, times (1 - t)^n, u = t / (1 - t); from the other end where t is over a
// half.
glm::dvec3 bernstein_horner(Control control, double t) {
  const std::size_t n = control.size() - 1;
  const bool is_late = t > 0.5;
  const double s = is_late ? t : 1 - t;
  const double u = is_late ? (1 - t) / t : t / (1 - t);
  const auto b = [&](std::size_t i) { return control[is_late ? n - i : i]; };
  glm::dvec3 sum = b(n);
  double binomial = 1;
  double power = 1;
  for (std::size_t i = n; i > 0; --i) {
    binomial = binomial * static_cast<double>(i) / static_cast<double>(n - i + 1);
    sum = sum * u + binomial * b(i - 1);
    power *= s;
  }
  return power * sum;
}

// a + b = sum + e exactly [Knuth].
double two_sum(double a, double b, double& e) {
  const double sum = a + b;
  const double part = sum - a;
  e = (a - (sum - part)) + (b - part);
  return sum;
}

// A double as two of 26 bits [Dekker].
void split(double a, double& high, double& low) {
  const double c = 134217729.0 * a;  // 2^27 + 1
  high = c - (c - a);
  low = a - high;
}

// a * b = product + e exactly; there is no fused multiply-add in this build.
double two_product(double a, double b, double& e) {
  const double product = a * b;
  double a_high, a_low, b_high, b_low;
  split(a, a_high, a_low);
  split(b, b_high, b_low);
  e = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
  return product;
}

double compensated_coordinate(Control control, glm::length_t axis, double t) {
  std::array<double, kMostPoints> b;
  std::array<double, kMostPoints> lost{};
  for (std::size_t i = 0; i < control.size(); ++i) b[i] = control[i][axis];
  double s_lost;
  const double s = two_sum(1, -t, s_lost);
  for (std::size_t left = control.size() - 1; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) {
      double e1, e2, e3;
      const double one = two_product(s, b[i], e1);
      const double two = two_product(t, b[i + 1], e2);
      const double local = s_lost * b[i];
      b[i] = two_sum(one, two, e3);
      lost[i] = s * lost[i] + (t * lost[i + 1] + (((e1 + e2) + e3) + local));
    }
  }
  return b[0] + lost[0];
}

glm::dvec3 compensated(Control control, double t) {
  return {compensated_coordinate(control, 0, t), compensated_coordinate(control, 1, t),
          compensated_coordinate(control, 2, t)};
}

// The coefficients of t^k: binomial(n, k) times the k-th forward difference at the start.
std::vector<glm::dvec3> power_coefficients(Control control) {
  std::vector<glm::dvec3> coefficients(control.begin(), control.end());
  const std::size_t n = control.size() - 1;
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t i = n; i >= k; --i) coefficients[i] -= coefficients[i - 1];
  }
  double binomial = 1;
  for (std::size_t k = 1; k <= n; ++k) {
    binomial = binomial * static_cast<double>(n - k + 1) / static_cast<double>(k);
    coefficients[k] *= binomial;
  }
  return coefficients;
}

void power_horner(Control control, Parameters parameters, Points points) {
  const std::vector<glm::dvec3> coefficients = power_coefficients(control);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    glm::dvec3 sum = coefficients.back();
    for (std::size_t i = coefficients.size() - 1; i > 0; --i) sum = sum * parameters[k] + coefficients[i - 1];
    points[k] = sum;
  }
}

template <glm::dvec3 (*evaluate)(Control, double)>
void at_each(Control control, Parameters parameters, Points points) {
  for (std::size_t k = 0; k < parameters.size(); ++k) points[k] = evaluate(control, parameters[k]);
}

}  // namespace

std::vector<BezierMethod> bezier_methods() {
  return {{"de Casteljau", at_each<de_casteljau>},
          {"Bernstein, Horner-like", at_each<bernstein_horner>},
          {"compensated de Casteljau", at_each<compensated>},
          {"powers, Horner", power_horner}};
}

}  // namespace sweepkit::report
