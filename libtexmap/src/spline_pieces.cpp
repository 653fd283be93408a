// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// One axis of [Heckbert86]: the filter w^-n sum_k (-1)^(n-k) C(n,k) F(left + k w), F the n-fold integral of
// the texels, each constant over its width. Heckbert gives integer knots or interpolates F; here it is exact
// between the texels as well, since the n-fold integral of a step function is the n-fold sum of its steps
// convolved with a B-spline:
//   F(i + t) = sum_q b_q(t) D(i + 1 - n + q),  q = 0..n,
// b the n + 1 uniform B-splines of degree n over a unit cell, D the n-fold sums, D(i) = D(i-1) + (the (n-1)-
// fold sum at i). For n = 1 that is linear interpolation of a summed-area table.
//
// Departs from Heckbert in the wraps as well: an axis is cut where a copy of the image ends, and each piece
// is a stretch [a, b) of the image. Past b the sums over a stretch go on as a polynomial of the n sums at b,
// so knots there weigh columns at b alone: no sum grows with what lies outside. In a mirrored copy the filter
// is mirrored instead, which leaves it as it is.
//   Repeat and mirror: a box of q periods and a rest of r weighs as q period means and a box of r, so n boxes
// weigh as (1 - (r/w)^n) means and (r/w)^n times n boxes of r (a mean convolved with anything is the mean).
//   Clamp: what lies outside is its border texel, times the spline's integral over there.
//
// Symbols: n order, w width of a box, a and b the ends of a stretch, i + t a knot's texel and the rest, D the
// table's columns, D^m = the m-th backward difference of D.

#include "spline_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "pyramid.hpp"

namespace sweepkit::texmap {
namespace {

using Weights = std::array<double, kMostOrder + 1>;

// The B-splines of degree n over a unit cell, n! times: whole at whole places.
Weights spline_basis(int order, double t) {
  const double s = 1 - t;
  if (order == 1) return {s, t};
  if (order == 2) return {s * s, 1 + 2 * t * s, t * t};
  return {s * s * s, (3 * t - 6) * t * t + 4, (3 * s - 6) * s * s + 4, t * t * t};
}

// n! F(b + z) by D, D^1, D^2 at b, for sums that end there.
Weights continuation(int order, double z) {
  if (order == 1) return {1};
  if (order == 2) return {2, 2 * z - 1};
  return {6, 6 * (z - 1), 3 * z * (z - 1) + 1};
}

// n + 1 columns that end with the one after texel i.
void add_group(AxisPiece& piece, int order, int i, const Weights& weights) {
  for (int q = 0; q <= order; ++q) {
    const int column = i + 1 - order + q;
    const int last = piece.count > 0 ? piece.column[static_cast<std::size_t>(piece.count) - 1] : column - 1;
    // Groups come in order, and the columns of the one before have no gap.
    if (column > last) piece.column[static_cast<std::size_t>(piece.count++)] = column;
    const int at = piece.count - 1 - (std::max(last, column) - column);
    piece.weight[static_cast<std::size_t>(at)] += weights[static_cast<std::size_t>(q)];
  }
}

// What weighs D, D^1, D^2 at b, told of the columns b-n .. b.
Weights on_columns(int order, const Weights& of_differences) {
  const auto& [d0, d1, d2, none] = of_differences;
  if (order == 1) return {0, d0};
  if (order == 2) return {0, -d1, d0 + d1};
  return {0, d2, -d1 - 2 * d2, d0 + d1 + d2};
}

void cut_into_runs(AxisPiece& piece) {
  while (piece.zeros < piece.count && piece.column[static_cast<std::size_t>(piece.zeros)] <= 0) ++piece.zeros;
  for (int at = piece.zeros; at < piece.count; ++at) {
    const int texel = piece.column[static_cast<std::size_t>(at)] - 1;
    const int tile = texel / kTileSide;
    const int offset = texel % kTileSide;
    if (piece.run_count > 0) {
      ColumnRun& run = piece.runs[static_cast<std::size_t>(piece.run_count) - 1];
      if (run.tile == tile && run.offset + run.count == offset) {
        ++run.count;
        continue;
      }
    }
    piece.runs[static_cast<std::size_t>(piece.run_count++)] = {tile, offset, at, 1};
  }
}

// Each texel of [a, b) weighed alike.
void add_even(int order, int a, int b, double weight, std::vector<AxisPiece>& pieces) {
  AxisPiece& piece = pieces.emplace_back();
  add_group(piece, order, a, {});
  // The single sum at b is the last difference but one.
  Weights of_differences{};
  of_differences[static_cast<std::size_t>(order) - 1] = weight;
  add_group(piece, order, b - 1, on_columns(order, of_differences));
  cut_into_runs(piece);
}

void add_spline(const SplineInterval& interval, int order, int a, int b, std::vector<AxisPiece>& pieces) {
  static constexpr std::array<std::array<double, 4>, 3> kSigned = {
      {{-1, 1}, {1, -2, 1}, {-1, 3, -3, 1}}};  // (-1)^(n-k) C(n,k)
  AxisPiece& piece = pieces.emplace_back();
  add_group(piece, order, a, {});
  Weights at_end{};
  bool reaches_end = false;
  for (int k = 0; k <= order; ++k) {
    const double knot = interval.left + k * interval.width;
    if (knot <= a) continue;
    const double sign = kSigned[static_cast<std::size_t>(order) - 1][static_cast<std::size_t>(k)];
    Weights weights = knot < b ? spline_basis(order, knot - std::floor(knot)) : continuation(order, knot - b);
    for (double& weight : weights) weight *= sign;
    if (knot < b) {
      add_group(piece, order, static_cast<int>(knot), weights);
    } else {
      reaches_end = true;
      for (std::size_t m = 0; m < weights.size(); ++m) at_end[m] += weights[m];
    }
  }
  if (reaches_end) add_group(piece, order, b - 1, on_columns(order, at_end));
  cut_into_runs(piece);
}

// The part of the spline over the image itself.
void add_spline_inside(const SplineInterval& interval, int order, int size, int longest,
                       std::vector<AxisPiece>& pieces) {
  const double right = interval.left + order * interval.width;
  const int a = static_cast<int>(std::clamp(std::floor(interval.left), 0.0, 1.0 * size));
  const int b = static_cast<int>(std::clamp(std::ceil(right), 0.0, 1.0 * size));
  if (a >= b) return;
  const std::int64_t parts = (std::int64_t{b} - a + longest - 1) / longest;
  for (std::int64_t part = 0; part < parts; ++part) {
    add_spline(interval, order, a + static_cast<int>((b - a) * part / parts),
               a + static_cast<int>((b - a) * (part + 1) / parts), pieces);
  }
}

// spline_total() times the integral of the spline from its left end over x.
double spline_integral(int order, double width, double x) {
  const double support = order * width;
  if (x <= 0) return 0;
  if (x >= support) return spline_total(order, width);
  if (2 * x > support) return spline_total(order, width) - spline_integral(order, width, support - x);
  if (order == 1) return x;
  if (order == 2) return x * x;
  const double past = std::max(x - width, 0.0);
  return x * x * x - 3 * past * past * past;
}

}  // namespace

double spline_total(int order, double width) {
  return order == 1 ? width : order == 2 ? 2 * width * width : 6 * width * width * width;
}

void cut_into_pieces(const SplineInterval& interval, int order, int size, Wrap wrap, int longest,
                     std::vector<AxisPiece>& pieces) {
  pieces.clear();
  auto [left, width] = interval;
  if (wrap == Wrap::kClamp) {
    const double before = spline_integral(order, width, -left);
    const double after = spline_integral(order, width, left + order * width - size);
    if (before > 0) add_even(order, 0, 1, before, pieces);
    add_spline_inside(interval, order, size, longest, pieces);
    if (after > 0) add_even(order, size - 1, size, after, pieces);
    return;
  }
  const double period = wrap == Wrap::kMirror ? 2.0 * size : size;
  if (width >= period) {
    const double rest = std::fmod(width, period);
    const double of_means = spline_total(order, width) - spline_total(order, rest);
    const std::int64_t parts = (std::int64_t{size} + longest - 1) / longest;
    for (std::int64_t part = 0; part < parts; ++part) {
      add_even(order, static_cast<int>(size * part / parts), static_cast<int>(size * (part + 1) / parts),
               of_means / size, pieces);
    }
    // A millionth of a millionth of the range is nothing that a float could show.
    if (spline_total(order, rest) < 1e-12 * of_means) return;
    width = rest;
  }
  left -= period * std::floor(left / period);
  const double right = left + order * width;
  for (int copy = 0; copy * static_cast<double>(size) < right; ++copy) {
    const bool is_mirrored = wrap == Wrap::kMirror && copy % 2 == 1;
    const double begin = static_cast<double>(copy) * size;
    add_spline_inside({is_mirrored ? begin + size - right : left - begin, width}, order, size, longest,
                      pieces);
  }
}

void weigh_texels(const SplineInterval& interval, int order, int first, std::span<double> weights) {
  double before = spline_integral(order, interval.width, first - interval.left);
  for (double& weight : weights) {
    const double after = spline_integral(order, interval.width, ++first - interval.left);
    weight = after - before;
    before = after;
  }
}

}  // namespace sweepkit::texmap
