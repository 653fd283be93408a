// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Crow84] and on Heckbert's reading of it as repeated integration of order 1 [Heckbert86].
// Departs from both in the arithmetic. Integer texels are summed in unsigned 64-bit words that may wrap
// round: any difference of corners whose true value is below 2^64 is exact, whatever the size of the table. A
// fractional corner would multiply a wrapped word and break that, so the four corners' neighbours are
// differenced as integers first and weighed after:
//   S(x1) - S(x0) = [S(i1) - S(i0)] + f1 [S(i1+1) - S(i1)] - f0 [S(i0+1) - S(i0)],   x = i + f,
// in x and in y, nine integer boxes from sixteen corners.
//
// Outside the image a table corner follows from the wrap: repeat by S(i+aW, j+bH) = S(i,j) + a S(W,j) + b
// S(i,H) + ab S(W,H), clamp by going on linearly past the border.

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

// One axis of a table corner as a sum of at most two table lines with integer weights.
struct Line {
  std::array<std::int64_t, 2> index;
  std::array<std::int64_t, 2> weight;
  int count;
};

Line resolve(std::int64_t i, std::int64_t size, Wrap wrap) {
  if (i >= 0 && i <= size) return {{i, 0}, {1, 0}, 1};
  if (wrap == Wrap::kRepeat) {
    const std::int64_t turns = i >= 0 ? i / size : -((-i + size - 1) / size);
    return {{i - turns * size, size}, {1, turns}, 2};
  }
  if (i < 0) return {{1, 0}, {i, 1 - i}, 2};
  return {{size, size - 1}, {1 + (i - size), -(i - size)}, 2};
}

template <class T>
struct Corners {
  const T* sums;
  std::int64_t width, height;
  Wrap wrap;

  const T* at(std::int64_t i, std::int64_t j) const { return sums + 3 * (j * (width + 1) + i); }

  std::array<T, 3> operator()(const Line& x, const Line& y) const {
    std::array<T, 3> sum{};
    for (int b = 0; b < y.count; ++b) {
      for (int a = 0; a < x.count; ++a) {
        const T* value = at(x.index[static_cast<std::size_t>(a)], y.index[static_cast<std::size_t>(b)]);
        const T weight =
            static_cast<T>(x.weight[static_cast<std::size_t>(a)] * y.weight[static_cast<std::size_t>(b)]);
        for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * value[k];
      }
    }
    return sum;
  }
};

// A box's true sum is below 2^63, where the signed conversion is one instruction and the unsigned one a
// branch.
double to_double(std::uint64_t sum) {
  return static_cast<double>(static_cast<std::int64_t>(sum));
}
double to_double(double sum) {
  return sum;
}

// Sum of the texels over [x0, x1] x [y0, y1] in texel units.
template <class T>
glm::dvec3 box_sum(const Corners<T>& corners, double x0, double x1, double y0, double y1) {
  struct Axis {
    std::array<std::int64_t, 4> corner;  // i0, i0 + 1, i1, i1 + 1
    std::array<double, 3> weight;        // of i0..i1, i1..i1+1, i0..i0+1
  };
  const auto axis = [](double from, double to) {
    const double low = std::floor(from);
    const double high = std::floor(to);
    const auto i0 = static_cast<std::int64_t>(low);
    const auto i1 = static_cast<std::int64_t>(high);
    return Axis{{i0, i0 + 1, i1, i1 + 1}, {1.0, to - high, low - from}};
  };
  const Axis x = axis(x0, x1);
  const Axis y = axis(y0, y1);
  std::array<std::array<std::array<T, 3>, 4>, 4> table;
  const bool is_inside =
      x.corner[0] >= 0 && x.corner[3] <= corners.width && y.corner[0] >= 0 && y.corner[3] <= corners.height;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_inside) {
        const T* value = corners.at(x.corner[i], y.corner[j]);
        table[j][i] = {value[0], value[1], value[2]};
      } else {
        table[j][i] = corners(resolve(x.corner[i], corners.width, corners.wrap),
                              resolve(y.corner[j], corners.height, corners.wrap));
      }
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
  if (wrap_ == Wrap::kRepeat) {
    // Whole turns do not matter; near the origin most boxes need no corner outside the table.
    const double x_turns = std::floor(x0 / width_) * width_;
    const double y_turns = std::floor(y0 / height_) * height_;
    x0 -= x_turns;
    x1 -= x_turns;
    y0 -= y_turns;
    y1 -= y_turns;
  }
  const double area = (x1 - x0) * (y1 - y0);
  if (const auto* integers = std::get_if<std::vector<std::uint64_t>>(&sums_)) {
    const Corners<std::uint64_t> corners{integers->data(), width_, height_, wrap_};
    return glm::vec3(box_sum(corners, x0, x1, y0, y1) / (area * 65535.0));
  }
  const Corners<double> corners{std::get<std::vector<double>>(sums_).data(), width_, height_, wrap_};
  return glm::vec3(offset_ + box_sum(corners, x0, x1, y0, y1) / area);
}

std::size_t SummedAreaTable::bytes() const {
  return std::visit([](const auto& sums) { return sums.size() * sizeof(sums[0]); }, sums_);
}

}  // namespace sweepkit::texmap
