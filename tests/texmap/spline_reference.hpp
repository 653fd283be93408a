// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "sweepkit/texmap/image.hpp"
#include "sweepkit/texmap/texture.hpp"

// Repeated integration written anew from its definition, without a table: every texel that the support
// touches, weighed by the integral of the B-spline over it.
namespace sweepkit::texmap::reference {

__extension__ using Whole = __int128;
using Quad = __float128;

inline std::int64_t wrapped(std::int64_t i, int size, Wrap wrap) {
  if (wrap == Wrap::kClamp) return std::clamp<std::int64_t>(i, 0, size - 1);
  const std::int64_t period = wrap == Wrap::kMirror ? 2 * size : size;
  const std::int64_t inside = ((i % period) + period) % period;
  return inside < size ? inside : period - 1 - inside;
}

/// The n-th power of x where it is positive. `Number` is Quad, or Whole for whole knots.
template <class Number>
Number truncated_power(Number x, int n) {
  Number power = 1;
  for (int i = 0; i < n; ++i) power *= x > 0 ? x : 0;
  return power;
}

/// n! w^n times the weights of texels first, first + 1, ... under n boxes of width w convolved, from `left`
/// on. Exact in integers.
template <class Number>
std::vector<Number> spline_weights(Number left, Number width, int n, std::int64_t first, std::int64_t count) {
  static constexpr int kBinomials[3][4] = {{1, -1, 0, 0}, {1, -2, 1, 0}, {1, -3, 3, -1}};
  // The n-fold integral of a point, n! times: the integral of the spline up to x, in whole.
  const auto up_to = [&](Number x) {
    Number sum = 0;
    for (int k = 0; k <= n; ++k)
      sum += kBinomials[n - 1][k] * truncated_power<Number>(x - left - k * width, n);
    return sum;
  };
  std::vector<Number> weights;
  Number before = up_to(static_cast<Number>(first));
  for (std::int64_t i = 0; i < count; ++i) {
    const Number after = up_to(static_cast<Number>(first + i + 1));
    weights.push_back(after - before);
    before = after;
  }
  return weights;
}

struct Box {
  double x, y;           // where it begins, in texels, y down
  double width, height;  // of one of the n boxes
};

/// A texel's value as a number.
template <class Number>
Number texel(const Image& image, std::int64_t x, std::int64_t y, int channel) {
  const auto at =
      static_cast<std::size_t>((y * image.width + x) * image.channels + (image.channels >= 3 ? channel : 0));
  if (const auto* integers = std::get_if<std::vector<std::uint16_t>>(&image.texels))
    return static_cast<Number>((*integers)[at]);
  return static_cast<Number>(std::get<std::vector<float>>(image.texels)[at]);
}

/// The texels of an axis that a box touches and what they weigh, those that the wrap brings back added up.
template <class Number>
std::vector<std::pair<std::int64_t, Number>> weighed_texels(double left, double width, int n, int size,
                                                            Wrap wrap) {
  const auto first = static_cast<std::int64_t>(std::floor(left));
  const auto count = static_cast<std::int64_t>(std::ceil(left + n * width)) - first;
  const std::vector<Number> weights =
      spline_weights<Number>(static_cast<Number>(left), static_cast<Number>(width), n, first, count);
  std::vector<std::pair<std::int64_t, Number>> texels;
  if (count <= size) {
    for (std::int64_t i = 0; i < count; ++i)
      texels.push_back({wrapped(first + i, size, wrap), weights[static_cast<std::size_t>(i)]});
    return texels;
  }
  for (std::int64_t i = 0; i < size; ++i) texels.push_back({i, 0});
  for (std::int64_t i = 0; i < count; ++i)
    texels[static_cast<std::size_t>(wrapped(first + i, size, wrap))].second +=
        weights[static_cast<std::size_t>(i)];
  return texels;
}

/// (n!)^2 w^n h^n times the filtered value, in the texels' own numbers.
template <class Number>
Number weighed_sum(const Image& image, Wrap wrap, const Box& box, int n, int channel) {
  const auto across = weighed_texels<Number>(box.x, box.width, n, image.width, wrap);
  const auto down = weighed_texels<Number>(box.y, box.height, n, image.height, wrap);
  Number sum = 0;
  for (const auto& [y, height] : down) {
    Number row = 0;
    for (const auto& [x, width] : across) row += width * texel<Number>(image, x, y, channel);
    sum += height * row;
  }
  return sum;
}

/// The filtered value itself, 65535 being 1 for integers.
template <class Number>
double value(const Image& image, Wrap wrap, const Box& box, int n, int channel) {
  static constexpr int kFactorials[] = {1, 1, 2, 6};
  const Number sum = weighed_sum<Number>(image, wrap, box, n, channel);
  Quad scale = kFactorials[n] * kFactorials[n];
  for (int i = 0; i < n; ++i) scale *= static_cast<Quad>(box.width) * static_cast<Quad>(box.height);
  return static_cast<double>(static_cast<Quad>(sum) / (scale * (image.is_float() ? 1 : 65535)));
}

/// Half a step of the float that is nearest to a value in [0, 1]: how far that may be away. What a double
/// adds by its own rounding is in the last digits.
inline double half_step(double want) {
  const double step = std::ldexp(1.0, std::max(std::ilogb(std::max(want, 1e-30)), -126) - 23);
  return 0.5000001 * step;
}

}  // namespace sweepkit::texmap::reference
