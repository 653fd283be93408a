// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

namespace sweepkit::texmap {

// What a triangle map asks of its number type besides the operators. Types that the standard library does not
// know (a quadruple one, one that counts) specialize both.

/// The step at 1: twice the largest relative rounding.
template <class Real>
inline constexpr double kEpsilon = std::numeric_limits<Real>::epsilon();

template <class Real>
Real square_root(const Real& x) {
  return std::sqrt(x);
}

}  // namespace sweepkit::texmap
