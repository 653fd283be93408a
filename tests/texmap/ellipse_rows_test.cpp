// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "ellipse_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "pyramid.hpp"

namespace sweepkit::texmap {
namespace {

struct Case {
  EllipseRows ellipse;
  float steepness;
  TileRows rows;
};

// Ellipses of every width, height and slant that fits a tile, whole ones and parts of ones.
std::vector<Case> random_cases(const std::vector<IntegerTexel>& tile) {
  std::mt19937 random(11);
  const auto from = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<Case> cases;
  while (cases.size() < 2000) {
    const double half_width = std::exp(from(0, std::log(28.0)));
    const double half_height = std::exp(from(0, std::log(28.0)));
    const double slant = from(-0.99, 0.99) * half_width * half_height;
    const double x = half_width + from(0, 1);
    const double y = half_height + from(0, 1);
    const double slope = slant / (half_height * half_height);
    const double across = half_width * half_width - slope * slant;
    Case one;
    one.ellipse = {.count = static_cast<int>(y + half_height),
                   .last_column = static_cast<int>(x + half_width),
                   .first_dy = static_cast<float>(1 - y),
                   .middle = static_cast<float>(x),
                   .slope = static_cast<float>(slope),
                   .across = static_cast<float>(across),
                   .per_height = static_cast<float>(1 / (half_height * half_height))};
    one.steepness = static_cast<float>(1 / across);
    const bool is_part = cases.size() % 2 == 1;
    const int first = is_part ? one.ellipse.last_column / 3 : 0;
    const int offset = static_cast<int>(from(0, kTileSide - one.ellipse.last_column - 1));
    one.rows = {.texels = tile.data(),
                .next_row = kTileSide,
                .count = one.ellipse.count,
                .offset = offset,
                .steepness = one.steepness,
                .is_part = is_part,
                .first_column = first,
                .last_column = std::max(first, one.ellipse.last_column * 2 / 3)};
    cases.push_back(one);
  }
  return cases;
}

std::vector<IntegerTexel> random_tile() {
  std::mt19937 random(12);
  std::vector<IntegerTexel> tile(kTileSide * kTileSide);
  for (IntegerTexel& texel : tile) {
    const auto number = [&] { return static_cast<std::uint16_t>(random() & 0xffff); };
    texel = IntegerTexel{number(), number(), number(), 65535};
  }
  return tile;
}

TEST(EllipseRows, AddUpAsALoopInDoubleDoes) {
  const std::vector<IntegerTexel> tile = random_tile();
  Spans spans;
  for (const Case& one : random_cases(tile)) {
    find_spans(one.ellipse, spans);
    EllipseSum sum;
    add_rows(one.rows, spans, sum);
    double wanted[4] = {};
    for (int k = 0; k < one.ellipse.count; ++k) {
      const double dy = static_cast<double>(one.ellipse.first_dy) + k;
      for (int column = 0; column <= one.ellipse.last_column; ++column) {
        if (one.rows.is_part && (column < one.rows.first_column || column > one.rows.last_column)) continue;
        const double dx =
            column - static_cast<double>(one.ellipse.middle) - static_cast<double>(one.ellipse.slope) * dy;
        const double root = 1 - dy * dy * static_cast<double>(one.ellipse.per_height) -
                            dx * dx * static_cast<double>(one.steepness);
        if (!(root > 0)) continue;
        const IntegerTexel& texel = tile[static_cast<std::size_t>(k * kTileSide + one.rows.offset + column)];
        for (int channel = 0; channel < 4; ++channel)
          wanted[channel] += root * root * static_cast<double>(texel[channel]);
      }
    }
    const Float4 total = sum.total();
    // A place is good to some 2^-17 of a texel in float (a slope of up to 7 over 28 rows). In the rows of
    // least width, a seventh of a texel, the root then errs by 14 times that, 1e-4; such ellipses cover less
    // than a tenth of their box. Elsewhere it errs by 1e-5 or less.
    const double bound = 65535.0 * 1e-5 * one.ellipse.count * (one.ellipse.last_column + 1);
    for (int channel = 0; channel < 4; ++channel)
      ASSERT_NEAR(static_cast<double>(total[channel]), wanted[channel], bound);
  }
}

TEST(EllipseRows, GiveTheSameBytesWithEveryInstructionSet) {
  const std::vector<IntegerTexel> tile = random_tile();
  Spans spans;
  Spans other_spans;
  for (const std::string& name : instruction_sets()) {
    SCOPED_TRACE(name);
    const EllipseKernels kernels = ellipse_kernels(name);
    for (const Case& one : random_cases(tile)) {
      find_spans(one.ellipse, spans);
      kernels.find_spans(one.ellipse, other_spans);
      ASSERT_EQ(spans.most_fours, other_spans.most_fours);
      EllipseSum sum;
      EllipseSum other;
      add_rows(one.rows, spans, sum);
      kernels.add_rows(one.rows, other_spans, other);
      ASSERT_EQ(std::memcmp(sum.lanes, other.lanes, sizeof sum.lanes), 0);
    }
  }
}

TEST(EllipseRows, KnowNoOtherInstructionSet) {
  EXPECT_EQ(ellipse_kernels("none").add_rows, nullptr);
}

}  // namespace
}  // namespace sweepkit::texmap
