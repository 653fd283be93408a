// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Crow84] and on Heckbert's reading of it as repeated integration of order 1 [Heckbert86].
// Departs from both in the arithmetic. Integer texels are summed in unsigned 64-bit words that may wrap
// round: a difference of corners is exact, whatever the size of the table. A fractional corner would multiply
// a wrapped word and break that, so the four corners' neighbours are differenced as integers first and
// weighed after:
//   S(x1) - S(x0) = [S(i1) - S(i0)] + f1 [S(i1+1) - S(i1)] - f0 [S(i0+1) - S(i0)],   x = i + f,
// in x and in y, nine integer boxes from sixteen corners.
//
// A box that leaves the image is cut into boxes inside it. Repeat: whole turns and what is left of one, which
// says the same as S(i+aW, j+bH) = S(i,j) + a S(W,j) + b S(i,H) + ab S(W,H). Clamp: the first and the last
// texel as often as the box goes past them, which says the same as going on linearly past the table's border.
// Done on the boxes instead of on the corners, no sum grows with the size of the box, so a box of a million
// turns is as exact as a small one.

#include "sweepkit/texmap/summed_area_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sweepkit::texmap {
namespace {

// Farther out than this many texels a double holds no fraction of one that would matter; the mean of all is
// the answer.
constexpr double kFarthest = 4503599627370496.0;  // 2^52

using Sum3 = std::array<std::uint64_t, 3>;

// A stretch of one axis inside the image, in texels, and how often it counts.
struct Stretch {
  double times, from, to;
};

// What [from, to] covers under the wrap, as at most three stretches.
struct Stretches {
  std::array<Stretch, 3> parts;
  std::size_t count = 0;
  double length = 0;

  void add(double times, double from, double to) {
    parts[count++] = {times, from, to};
    length += times * (to - from);
  }
};

Stretches cut(double from, double to, double size, Wrap wrap) {
  Stretches stretches;
  if (from >= 0 && to <= size) {
    stretches.add(1, from, to);
  } else if (wrap == Wrap::kRepeat) {
    const double turns = std::floor((to - from) / size);
    if (turns > 0) stretches.add(turns, 0, size);
    const double rest = std::max(0.0, (to - from) - turns * size);
    from = std::clamp(from - std::floor(from / size) * size, 0.0, size);
    to = from + rest;
    if (to > size && turns > 0) {
      // Another whole turn but for what lies between: one stretch less to sum.
      stretches.parts[0].times += 1;
      stretches.length += size;
      stretches.add(-1, std::min(to - size, from), from);
    } else {
      stretches.add(1, from, std::min(to, size));
      if (to > size) stretches.add(1, 0, std::min(to - size, size));
    }
  } else {
    if (from < 0) stretches.add(std::min(to, 0.0) - from, 0, 1);
    if (from < size && to > 0) stretches.add(1, std::max(from, 0.0), std::min(to, size));
    if (to > size) stretches.add(to - std::max(from, size), size - 1, size);
  }
  return stretches;
}

// The sum of a box inside the image is below 2^63, where the signed conversion is one instruction and the
// unsigned one a branch.
double to_double(std::uint64_t sum) {
  return static_cast<double>(static_cast<std::int64_t>(sum));
}
double to_double(double sum) {
  return sum;
}

// Sum of the texels over x and y, which lie inside the image of width x height.
template <class T>
glm::dvec3 box_sum(const T* sums, std::int64_t width, std::int64_t height, const Stretch& x_range,
                   const Stretch& y_range) {
  struct Axis {
    std::array<std::int64_t, 4> corner;  // i0, i0 + 1, i1, i1 + 1
    std::array<double, 3> weight;        // of i0..i1, i1..i1+1, i0..i0+1
  };
  const auto axis = [](const Stretch& range, std::int64_t size) {
    const auto i0 = static_cast<std::int64_t>(range.from);  // neither is below 0
    const auto i1 = static_cast<std::int64_t>(range.to);
    // The last line has none after it, and no fraction that would need one.
    return Axis{{i0, std::min(i0 + 1, size), i1, std::min(i1 + 1, size)},
                {1.0, range.to - static_cast<double>(i1), static_cast<double>(i0) - range.from}};
  };
  const Axis x = axis(x_range, width);
  const Axis y = axis(y_range, height);
  std::array<std::array<std::array<T, 3>, 4>, 4> table;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const T* value = sums + 3 * (y.corner[j] * (width + 1) + x.corner[i]);
      table[j][i] = {value[0], value[1], value[2]};
    }
  }
  static constexpr std::array<std::array<std::size_t, 2>, 3> kSpans = {{{0, 2}, {2, 3}, {0, 1}}};
  glm::dvec3 sum(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    double total = 0;
    for (std::size_t b = 0; b < 3; ++b) {
      const auto [j0, j1] = kSpans[b];
      double row = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        const auto [i0, i1] = kSpans[a];
        // The integer difference comes first: it is exact however often the words have wrapped.
        const T box = (table[j1][i1][k] - table[j1][i0][k]) - (table[j0][i1][k] - table[j0][i0][k]);
        row += x.weight[a] * to_double(box);
      }
      total += y.weight[b] * row;
    }
    sum[static_cast<glm::length_t>(k)] = total;
  }
  return sum;
}

// The mean of the table over a box that the wrap has cut up.
template <class T>
glm::dvec3 mean_over(const std::vector<T>& sums, int width, int height, const Stretches& x,
                     const Stretches& y) {
  glm::dvec3 sum(0.0);
  for (std::size_t j = 0; j < y.count; ++j) {
    for (std::size_t i = 0; i < x.count; ++i) {
      sum +=
          x.parts[i].times * y.parts[j].times * box_sum(sums.data(), width, height, x.parts[i], y.parts[j]);
    }
  }
  return sum / (x.length * y.length);
}

template <class T, class Texel>
std::vector<T> integrate(int width, int height, Texel&& texel) {
  const auto columns = static_cast<std::size_t>(width) + 1;
  std::vector<T> sums(3 * columns * (static_cast<std::size_t>(height) + 1), T{});
  for (int y = 0; y < height; ++y) {
    std::array<T, 3> row{};
    const T* above = sums.data() + 3 * columns * static_cast<std::size_t>(y);
    T* here = sums.data() + 3 * columns * (static_cast<std::size_t>(y) + 1);
    for (int x = 0; x < width; ++x) {
      const std::array<T, 3> value = texel(x, y);
      for (std::size_t k = 0; k < 3; ++k) {
        row[k] += value[k];
        const std::size_t at = 3 * (static_cast<std::size_t>(x) + 1) + k;
        here[at] = above[at] + row[k];
      }
    }
  }
  return sums;
}

}  // namespace

SummedAreaTable::SummedAreaTable(const Image& image, Wrap wrap)
    : width_(image.width), height_(image.height), wrap_(wrap) {
  const std::size_t green = image.channels >= 3 ? 1 : 0;
  const std::size_t blue = image.channels >= 3 ? 2 : 0;
  const auto first = [&](int x, int y) {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(image.channels);
  };
  if (const auto* integers = std::get_if<std::vector<std::uint16_t>>(&image.texels)) {
    sums_ = integrate<std::uint64_t>(width_, height_, [&](int x, int y) {
      const std::uint16_t* texel = integers->data() + first(x, y);
      return Sum3{texel[0], texel[green], texel[blue]};
    });
    return;
  }
  const auto& floats = std::get<std::vector<float>>(image.texels);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const float* texel = floats.data() + first(x, y);
      offset_ += glm::dvec3(texel[0], texel[green], texel[blue]);
    }
  }
  offset_ /= static_cast<double>(width_) * static_cast<double>(height_);
  sums_ = integrate<double>(width_, height_, [&](int x, int y) {
    const float* texel = floats.data() + first(x, y);
    return std::array<double, 3>{texel[0] - offset_[0], texel[green] - offset_[1], texel[blue] - offset_[2]};
  });
}

glm::vec3 SummedAreaTable::mean(const UvBox& box) const {
  double x0 = box.min.x * width_;
  double x1 = box.max.x * width_;
  double y0 = (1 - box.max.y) * height_;
  double y1 = (1 - box.min.y) * height_;
  // Written so that NaN, too, takes the mean of all.
  const bool is_usable =
      x0 > -kFarthest && x1 < kFarthest && y0 > -kFarthest && y1 < kFarthest && x0 <= x1 && y0 <= y1;
  if (!is_usable) {
    x0 = y0 = 0;
    x1 = width_;
    y1 = height_;
  }
  if (x1 - x0 < 1) {
    x0 = 0.5 * (x0 + x1) - 0.5;
    x1 = x0 + 1;
  }
  if (y1 - y0 < 1) {
    y0 = 0.5 * (y0 + y1) - 0.5;
    y1 = y0 + 1;
  }
  const Stretches x = cut(x0, x1, width_, wrap_);
  const Stretches y = cut(y0, y1, height_, wrap_);
  if (const auto* integers = std::get_if<std::vector<std::uint64_t>>(&sums_))
    return glm::vec3(mean_over(*integers, width_, height_, x, y) / 65535.0);
  return glm::vec3(offset_ + mean_over(std::get<std::vector<double>>(sums_), width_, height_, x, y));
}

std::size_t SummedAreaTable::bytes() const {
  return std::visit([](const auto& sums) { return sums.size() * sizeof(sums[0]); }, sums_);
}

}  // namespace sweepkit::texmap
