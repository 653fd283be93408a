// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "quad.hpp"

namespace sweepkit::report {

/// A value with its first three derivatives by u: a Taylor series cut short, so that a curve's formula gives
/// its derivatives as well.
template <class Real>
struct Jet {
  std::array<Real, 4> d{};
};

template <class Real>
Jet<Real> operator+(const Jet<Real>& a, const Jet<Real>& b) {
  return {{a.d[0] + b.d[0], a.d[1] + b.d[1], a.d[2] + b.d[2], a.d[3] + b.d[3]}};
}

// Leibniz's rule.
template <class Real>
Jet<Real> operator*(const Jet<Real>& a, const Jet<Real>& b) {
  return {{a.d[0] * b.d[0], a.d[1] * b.d[0] + a.d[0] * b.d[1],
           a.d[2] * b.d[0] + 2 * a.d[1] * b.d[1] + a.d[0] * b.d[2],
           a.d[3] * b.d[0] + 3 * a.d[2] * b.d[1] + 3 * a.d[1] * b.d[2] + a.d[0] * b.d[3]}};
}

template <class Real>
Jet<Real> constant(const Real& c) {
  return {{c, 0, 0, 0}};
}

/// cos(k u).
template <class Real>
Jet<Real> cosine_of(int k, const Real& u) {
  const Real c = cosine(k * u);
  const Real s = sine(k * u);
  return {{c, -k * s, -k * k * c, k * k * k * s}};
}

/// sin(k u).
template <class Real>
Jet<Real> sine_of(int k, const Real& u) {
  const Real c = cosine(k * u);
  const Real s = sine(k * u);
  return {{s, k * c, -k * k * s, -k * k * k * c}};
}

}  // namespace sweepkit::report
