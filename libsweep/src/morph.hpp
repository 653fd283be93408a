// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "section.hpp"

namespace sweepkit::sweep {

/// One outline of a contour as it changes along a trajectory: sections of as many points each, point i of one
/// going to point i of the next. One key is an outline that does not change.
struct Morph {
  std::vector<Section> keys;
  std::vector<double> at;  ///< ascending shares of the trajectory's length, one a key
  /// The rate at key k is x (p[k] - p[k-1]) / step + y (p[k+1] - p[k]) / step.
  std::vector<glm::dvec2> slopes;

  bool changes() const { return keys.size() > 1; }
  std::size_t columns() const { return keys.front().points.size() - 1; }
};

/// Section(t) = sum of `value` times the key's, and its change by t the same with `rate`.
struct KeyWeight {
  std::size_t key = 0;
  double value = 1;
  double rate = 0;
};
struct KeyWeights {
  std::array<KeyWeight, 4> of;
  int count = 1;
};
/// Fills in `slopes`. Precondition: the keys and where they are are there.
void find_slopes(Morph& morph);

KeyWeights key_weights(const Morph& morph, double t);

/// A point of the section: its place, its direction along the section, how it changes by t.
struct MorphPoint {
  glm::dvec2 position;
  glm::dvec2 tangent;
  glm::dvec2 rate{0.0};
};

inline MorphPoint point_at(const Morph& morph, const KeyWeights& weights, std::size_t column,
                           bool is_leaving) {
  const auto side = [is_leaving](const SectionPoint& point) {
    return is_leaving ? point.tangent_out : point.tangent_in;
  };
  if (!morph.changes()) {
    const SectionPoint& point = morph.keys.front().points[column];
    return {point.position, side(point)};
  }
  MorphPoint sum{glm::dvec2(0.0), glm::dvec2(0.0)};
  for (int k = 0; k < weights.count; ++k) {
    const KeyWeight& weight = weights.of[static_cast<std::size_t>(k)];
    const SectionPoint& point = morph.keys[weight.key].points[column];
    sum.position += weight.value * point.position;
    sum.tangent += weight.value * side(point);
    sum.rate += weight.rate * point.position;
  }
  return sum;
}

/// The whole section at t.
Section section_at(const Morph& morph, double t);

/// The farthest that any section of them lies from the trajectory.
double reach_of(const std::vector<Morph>& morphs);

}  // namespace sweepkit::sweep
