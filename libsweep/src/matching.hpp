// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

/// A contour and which way it is walked; places on it are shares of its length, 0 to 1, in that direction.
class Walk {
 public:
  struct Corner {
    double at;
    std::size_t segment;  ///< begins there, in the curve's own direction
  };
  /// The two sides of a place: the same but at a corner.
  struct Place {
    CurveLocation in, out;
    bool is_corner = false;
  };

  /// Keeps a pointer to `curve`.
  Walk(const Curve2& curve, bool is_backward);

  const Curve2& curve() const { return *curve_; }
  double direction() const { return is_backward_ ? -1 : 1; }
  /// Ascending from 0 on; what an open curve has at its ends is none.
  const std::vector<Corner>& corners() const { return corners_; }
  /// `at` is taken round a closed curve.
  Place place(double at) const;
  glm::dvec2 position(double at) const;

 private:
  const Curve2* curve_;
  bool is_backward_;
  std::vector<Corner> corners_;
};

/// A continuous, rising, piecewise linear function, given by its knots (x, y).
struct RisingMap {
  std::vector<glm::dvec2> knots;  ///< both ascending, at least two

  double at(double x) const;
  double inverse(double y) const;
};

/// Which place of `to` each place of `from` goes to: from [0, 1] on to [0, 1], or for closed contours to [s,
/// s
/// + 1], s the start. Chosen so that the points move little, corners go to corners near them, and the shapes
/// between do not cross themselves where a start is found for which they do not.
RisingMap match(const Walk& from, const Walk& to);

}  // namespace sweepkit::sweep
