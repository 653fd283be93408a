// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The rotation-minimizing normal at u is cos(a) N + sin(a) B of Frenet's frame (T, N, B), with a(u) =
// -integral of torsion times speed from the start: where Frenet's frame turns about T by the torsion, this
// one does not.

#include "test_curves.hpp"

#include <array>
#include <numbers>

#include "jet.hpp"

namespace sweepkit::report {
namespace {

template <class Real>
using Point = std::array<Jet<Real>, 3>;  // a coordinate each

template <class Real>
using Triple = std::array<Real, 3>;

struct Helix {
  template <class Real>
  static Point<Real> at(const Real& u) {
    return {cosine_of<Real>(1, u), sine_of<Real>(1, u), Jet<Real>{{u / 2, Real(0.5), 0, 0}}};
  }
};

struct Knot {
  template <class Real>
  static Point<Real> at(const Real& u) {
    const Real wide = Real(6) / 10;
    const Real tube = Real(3) / 10;
    const Jet<Real> r = constant(wide) + constant(tube) * cosine_of<Real>(7, u);
    return {r * cosine_of<Real>(2, u), r * sine_of<Real>(2, u), constant(tube) * sine_of<Real>(7, u)};
  }
};

struct Bezier {
  template <class Real>
  static Point<Real> at(const Real& u) {
    static constexpr int kControl[4][3] = {{0, 0, 0}, {1, 2, 0}, {3, -1, 2}, {4, 1, 1}};
    const Jet<Real> t{{u, 1, 0, 0}};
    const Jet<Real> s{{1 - u, -1, 0, 0}};
    Point<Real> point;
    for (std::size_t k = 0; k < 3; ++k) {
      point[k] = constant(Real(kControl[0][k])) * s * s * s + constant(Real(3 * kControl[1][k])) * s * s * t +
                 constant(Real(3 * kControl[2][k])) * s * t * t + constant(Real(kControl[3][k])) * t * t * t;
    }
    return point;
  }
};

template <class Real>
Triple<Real> derivative(const Point<Real>& point, std::size_t order) {
  return {point[0].d[order], point[1].d[order], point[2].d[order]};
}

Quad dot(const Triple<Quad>& a, const Triple<Quad>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple<Quad> cross(const Triple<Quad>& a, const Triple<Quad>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Triple<Quad> unit(const Triple<Quad>& a) {
  const Quad length = square_root(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

Quad torsion_by_parameter(const Point<Quad>& point) {
  const Triple<Quad> first = derivative(point, 1);
  const Triple<Quad> binormal = cross(first, derivative(point, 2));
  return dot(binormal, derivative(point, 3)) / dot(binormal, binormal) * square_root(dot(first, first));
}

template <class Formula>
std::vector<glm::dvec3> exact_normals(double from, double to, int steps) {
  std::vector<glm::dvec3> normals;
  Quad angle = 0;
  Quad u = from;
  for (int i = 0; i <= steps; ++i) {
    // The very parameter that evaluate() is asked for.
    const Quad next = from + (to - from) * i / steps;
    if (i > 0) {
      angle -=
          integrate(u, next, 1, [](Quad at) { return torsion_by_parameter(Formula::template at<Quad>(at)); });
    }
    u = next;
    const Point<Quad> point = Formula::template at<Quad>(u);
    const Triple<Quad> tangent = unit(derivative(point, 1));
    const Triple<Quad> binormal = unit(cross(derivative(point, 1), derivative(point, 2)));
    const Triple<Quad> normal = cross(binormal, tangent);
    const Quad c = cosine(angle);
    const Quad s = sine(angle);
    normals.emplace_back(static_cast<double>(c * normal[0] + s * binormal[0]),
                         static_cast<double>(c * normal[1] + s * binormal[1]),
                         static_cast<double>(c * normal[2] + s * binormal[2]));
  }
  return normals;
}

template <class Formula>
TestCurve make_curve(std::string name, std::string title, double to) {
  const auto evaluate = [](double u) {
    const Point<double> point = Formula::template at<double>(u);
    const auto vector = [&](std::size_t order) {
      const Triple<double> d = derivative(point, order);
      return glm::dvec3(d[0], d[1], d[2]);
    };
    return sweep::CurvePoint<3>{vector(0), vector(1), vector(2), vector(3)};
  };
  const auto normals = [to](int steps) { return exact_normals<Formula>(0, to, steps); };
  return {std::move(name), std::move(title), 0, to, evaluate, normals};
}

}  // namespace

std::vector<TestCurve> test_curves() {
  constexpr double kPi = std::numbers::pi;
  return {make_curve<Helix>("H", "helix (cos u, sin u, u/2), u to 4 pi", 4 * kPi),
          make_curve<Knot>("K", "knot r = 0.6 + 0.3 cos 7u, (r cos 2u, r sin 2u, 0.3 sin 7u), u to 2 pi",
                           2 * kPi),
          make_curve<Bezier>("B", "cubic Bezier (0,0,0), (1,2,0), (3,-1,2), (4,1,1)", 1)};
}

}  // namespace sweepkit::report
