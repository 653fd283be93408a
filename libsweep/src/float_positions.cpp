// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "float_positions.hpp"

#include <algorithm>
#include <cmath>

#include "number_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

// Numbers below 1.2e-38 have fewer than 24 bits in float32: a ten-millionth of the object is to have them
// all. The largest number is 3.4e38.
constexpr double kSmallest = 1e-30;
constexpr double kLargest = 1e38;

}  // namespace

glm::dvec3 choose_origin(const Box& box) {
  const glm::dvec3 size = box.high - box.low;
  const double extent = std::max({size.x, size.y, size.z});
  if (!(extent >= kSmallest && extent <= kLargest)) {
    throw InputError("is " + number_text(extent) + " m large; float32 positions need it between " +
                     number_text(kSmallest) + " and " + number_text(kLargest) + " m");
  }
  const double step = std::exp2(std::ceil(std::log2(extent)));
  const glm::dvec3 middle = 0.5 * (box.low + box.high);
  // Adding 0 turns -0 into 0.
  return {step * std::nearbyint(middle.x / step) + 0.0, step * std::nearbyint(middle.y / step) + 0.0,
          step * std::nearbyint(middle.z / step) + 0.0};
}

double float_error(const Box& box) {
  // Half a unit in the last place of each coordinate.
  const glm::dvec3 origin = choose_origin(box);
  return std::exp2(-24) * glm::length(glm::max(glm::abs(box.low - origin), glm::abs(box.high - origin)));
}

double tolerance_left(double tolerance, const Box& box) {
  const double error = float_error(box);
  if (!(2 * error <= tolerance)) {
    throw InputError("tolerance of " + number_text(tolerance) +
                     " m is finer than float32 positions of an object so large; ask for at least " +
                     number_text(2 * error) + " m");
  }
  return tolerance - error;
}

}  // namespace sweepkit::sweep
