// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <variant>
#include <vector>

namespace sweepkit::sweep {

/// A number that changes along a trajectory, t its share of the trajectory's length, 0 to 1. Before the first
/// and after the last given t it keeps the value it has there.
class Law {
 public:
  struct Value {
    double value;
    double rate;  ///< by t; where a Bezier law stands upright a finite number stands in, steep enough to show
  };

  /// The same number everywhere. Throws InputError unless it is finite.
  Law(double value);  // NOLINT: a number is a law

  /// Through the points (t, value), smooth, and rising or falling only where the points do: it never
  /// overshoots [Fritsch and Butland 1984]. Throws InputError without a point, for t outside of 0 to 1 or not
  /// ascending, for values that are not finite.
  static Law through(const std::vector<glm::dvec2>& points);

  /// A Bezier curve in the plane of (t, value). Throws InputError as through() does, where equal t may follow
  /// each other but not all be the same.
  static Law bezier(const std::vector<glm::dvec2>& control);

  Value at(double t) const;
  bool is_constant() const;

 private:
  struct Knot {
    double t, value, slope;
  };
  struct Bezier {
    std::vector<glm::dvec2> control;
  };
  explicit Law(std::vector<Knot> knots) : shape_(std::move(knots)) {}
  explicit Law(Bezier bezier) : shape_(std::move(bezier)) {}

  std::variant<std::vector<Knot>, Bezier> shape_;  // one knot: a constant
};

}  // namespace sweepkit::sweep
