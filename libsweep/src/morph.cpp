// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Between two keys the points go by Hermite's cubic. The rate at a key between two others is a mean of the
// steps before (a) and after (b), each point's by the same shares, so that directions along the section are
// exact: with A and B the mean speeds of all points, c the cosine between a and b over all points, and w the
// weight of Fritsch and Butland (1984),
//   rate = c H (a / A + b / B) / 2,   H = A B / ((1 - w) A + w B),   0 where c < 0.
// So a shape that rests beside one that moves does not overshoot, and one that goes on evenly is not slowed.
// Two keys at both ends of the trajectory are joined straight; keys inside of it begin and end at rest.

#include "morph.hpp"

#include <algorithm>
#include <cmath>

namespace sweepkit::sweep {
namespace {

// Sum over all points of the product of two steps, key to key.
double product(const Morph& morph, std::size_t step, std::size_t other) {
  double sum = 0;
  for (std::size_t i = 0; i < morph.keys.front().points.size(); ++i) {
    const auto way = [&](std::size_t k) {
      return morph.keys[k + 1].points[i].position - morph.keys[k].points[i].position;
    };
    sum += glm::dot(way(step), way(other));
  }
  return sum;
}

}  // namespace

void find_slopes(Morph& morph) {
  const std::size_t last = morph.keys.size() - 1;
  morph.slopes.assign(last + 1, glm::dvec2(0.0));
  if (last == 0) return;
  const auto width = [&](std::size_t step) { return morph.at[step + 1] - morph.at[step]; };
  for (std::size_t k = 1; k < last; ++k) {
    const double before = std::sqrt(product(morph, k - 1, k - 1)) / width(k - 1);
    const double after = std::sqrt(product(morph, k, k)) / width(k);
    if (!(before > 0 && after > 0)) continue;
    const double cosine = product(morph, k - 1, k) / (before * after * width(k - 1) * width(k));
    if (!(cosine > 0)) continue;
    const double w = (1 + width(k) / (width(k - 1) + width(k))) / 3;
    const double speed = before * after / ((1 - w) * before + w * after);
    morph.slopes[k] = 0.5 * cosine * speed / glm::dvec2(before, after);
  }
  // At an end of the trajectory as the step goes.
  if (morph.at.front() == 0) morph.slopes.front() = {0, 1};
  if (morph.at.back() == 1) morph.slopes.back() = {1, 0};
}

KeyWeights key_weights(const Morph& morph, double t) {
  const std::vector<double>& at = morph.at;
  if (!morph.changes() || t < at.front()) return {};
  if (t > at.back()) return {{{{at.size() - 1, 1, 0}}}, 1};
  const auto after = std::upper_bound(at.begin() + 1, at.end() - 1, t);
  const auto k = static_cast<std::size_t>(after - at.begin()) - 1;
  const double step = at[k + 1] - at[k];
  const double x = (t - at[k]) / step;
  // Hermite's basis and its derivative by x.
  const double h1 = x * x * (3 - 2 * x);
  const double m0 = x * (1 - x) * (1 - x);
  const double m1 = x * x * (x - 1);
  const double h1_rate = 6 * x * (1 - x);
  const double m0_rate = (1 - x) * (1 - 3 * x);
  const double m1_rate = x * (3 * x - 2);

  KeyWeights weights;
  weights.count = 0;
  const auto add = [&](std::size_t key, double value, double rate) {
    for (int i = 0; i < weights.count; ++i) {
      KeyWeight& weight = weights.of[static_cast<std::size_t>(i)];
      if (weight.key != key) continue;
      weight.value += value;
      weight.rate += rate / step;
      return;
    }
    weights.of[static_cast<std::size_t>(weights.count++)] = {key, value, rate / step};
  };
  add(k, 1 - h1, -h1_rate);
  add(k + 1, h1, h1_rate);
  const auto add_slope = [&](std::size_t key, double value, double rate) {
    const glm::dvec2 slope = morph.slopes[key];
    if (slope.x != 0) {
      const double scale = slope.x * step / (at[key] - at[key - 1]);
      add(key, scale * value, scale * rate);
      add(key - 1, -scale * value, -scale * rate);
    }
    if (slope.y != 0) {
      const double scale = slope.y * step / (at[key + 1] - at[key]);
      add(key + 1, scale * value, scale * rate);
      add(key, -scale * value, -scale * rate);
    }
  };
  add_slope(k, m0, m0_rate);
  add_slope(k + 1, m1, m1_rate);
  return weights;
}

Section section_at(const Morph& morph, double t) {
  Section section = morph.keys.front();
  if (!morph.changes()) return section;
  const KeyWeights weights = key_weights(morph, t);
  for (std::size_t i = 0; i < section.points.size(); ++i) {
    const MorphPoint in = point_at(morph, weights, i, false);
    section.points[i] = {in.position, in.tangent, point_at(morph, weights, i, true).tangent};
  }
  return section;
}

double reach_of(const std::vector<Morph>& morphs) {
  double reach = 0;
  for (const Morph& morph : morphs) {
    for (const Section& key : morph.keys) reach = std::max(reach, reach_of(key));
  }
  return reach;
}

}  // namespace sweepkit::sweep
