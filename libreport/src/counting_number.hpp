// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <compare>

#include "sweepkit/texmap/number_type.hpp"

namespace sweepkit::texmap {

/// Operations done by counting numbers of this thread. Differences, sums and comparisons are not counted: the
/// paper does not.
struct OperationCounts {
  int multiplications = 0;
  int divisions = 0;
  int square_roots = 0;

  int products() const { return multiplications + divisions; }
};
inline thread_local OperationCounts operation_counts;

/// A double that counts what is done to it.
struct CountingNumber {
  double value;  // not set: glm keeps its numbers in unions, which takes trivial ones

  CountingNumber() = default;
  CountingNumber(double of) : value(of) {}  // NOLINT: as implicit as a number
  explicit operator double() const { return value; }

  CountingNumber operator-() const { return -value; }
  friend CountingNumber operator+(CountingNumber x, CountingNumber y) { return x.value + y.value; }
  friend CountingNumber operator-(CountingNumber x, CountingNumber y) { return x.value - y.value; }
  friend CountingNumber operator*(CountingNumber x, CountingNumber y) {
    ++operation_counts.multiplications;
    return x.value * y.value;
  }
  friend CountingNumber operator/(CountingNumber x, CountingNumber y) {
    ++operation_counts.divisions;
    return x.value / y.value;
  }
  CountingNumber& operator+=(CountingNumber y) { return *this = *this + y; }
  CountingNumber& operator-=(CountingNumber y) { return *this = *this - y; }
  CountingNumber& operator*=(CountingNumber y) { return *this = *this * y; }
  CountingNumber& operator/=(CountingNumber y) { return *this = *this / y; }
  friend auto operator<=>(CountingNumber x, CountingNumber y) = default;
};

template <>
inline constexpr double kEpsilon<CountingNumber> = kEpsilon<double>;

template <>
inline CountingNumber square_root(const CountingNumber& x) {
  ++operation_counts.square_roots;
  return std::sqrt(x.value);
}

/// What `work` does.
template <class Work>
OperationCounts count_operations(Work&& work) {
  operation_counts = {};
  work();
  return operation_counts;
}

}  // namespace sweepkit::texmap
