// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "texel.hpp"

namespace sweepkit::texmap {

/// An ellipse over rows of texels. Columns count from the left of its box, rows from the first that it
/// covers.
struct EllipseRows {
  int count = 0;         ///< rows
  int last_column = 0;   ///< of the box
  float first_dy = 0;    ///< from the ellipse's middle to row 0
  float middle = 0;      ///< the column of that
  float slope = 0;       ///< the rows' middles move by this much a row
  float across = 0;      ///< the squared half width of the row through the middle
  float per_height = 0;  ///< 1 over the squared half height
};

/// The parts of those rows that lie under it, an array for each number. A texel dx from the middle weighs
/// (top - steepness dx^2)^2; those on the rim weigh nothing and may be in or out.
struct Spans {
  std::vector<std::int32_t> first;
  std::vector<std::int32_t> last;
  std::vector<float> top;     ///< what is left of 1 in this row where the weight is greatest
  std::vector<float> middle;  ///< where that is
  int most_fours = 0;         ///< fours of texels that the widest takes
};

/// The rows of one tile that lie under the ellipse.
struct TileRows {
  const IntegerTexel* texels = nullptr;  ///< of the tile's row that the first lies in, from the tile's left
  std::ptrdiff_t next_row = 0;           ///< in texels
  int first_row = 0;                     ///< of the spans
  int count = 0;
  int offset = 0;  ///< where column 0 lies in the tile's rows
  float steepness = 0;
  /// Where the ellipse's box reaches past this tile: the columns of it that are added.
  bool is_part = false;
  int first_column = 0;
  int last_column = 0;
};

/// The sum of weighed texels, with 65535 times the sum of the weights last; in four chains, the i-th of each
/// four of a row in the i-th, on every machine.
struct EllipseSum {
  alignas(64) float lanes[16] = {};

  Float4 total() const {
    const auto chain = [this](int i) {
      return Float4{lanes[4 * i], lanes[4 * i + 1], lanes[4 * i + 2], lanes[4 * i + 3]};
    };
    return (chain(0) + chain(2)) + (chain(1) + chain(3));
  }
};

/// With the best instructions that the machine has; the same bytes with any.
void find_spans(const EllipseRows& ellipse, Spans& spans);
void add_rows(const TileRows& rows, const Spans& spans, EllipseSum& sum);

/// The same with one of the instruction sets that this machine has and this library knows.
struct EllipseKernels {
  void (*find_spans)(const EllipseRows& ellipse, Spans& spans);
  void (*add_rows)(const TileRows& rows, const Spans& spans, EllipseSum& sum);
};
std::vector<std::string> instruction_sets();
EllipseKernels ellipse_kernels(const std::string& instruction_set);

}  // namespace sweepkit::texmap
