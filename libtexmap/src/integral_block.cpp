// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// wy^T S wx, S the n-fold sums over a block of texels alone, out of a table D of n-fold sums over all texels
// left and above, in words that wrap round [Crow84, Heckbert86]. Fractions may multiply no wrapped word, so
// what the texels before the block have left in column i is taken off first, along y and then along x:
//   S(i) = D(i) - sum_m C(i - a + m - 1, m) D^m(a),  m = 0..n-1.
// That is exact however often the words have wrapped, and what is left is small.
//
// Symbols: n order; a where the block begins, whose n columns up to a are the anchor; D^m the m-th backward
// difference of D at a: D itself, its slope and its bend.

#include "integral_block.hpp"

#include <algorithm>
#include <cstdint>

namespace sweepkit::texmap {
namespace {

using Words = std::array<std::uint64_t, 3>;

// How far a column lies past the anchor.
template <int order>
std::uint64_t distance(const AxisPiece& piece, std::size_t at) {
  return static_cast<std::uint64_t>(piece.column[at] - piece.column[order - 1]);
}

template <int order>
class Block {
 public:
  Block(const AxisPiece& across, const AxisPiece& down) : across_(across), down_(down) {}

  void load(const IntegralTable& table, TileReader& reader) {
    for (std::size_t r = 0; r < rows(); ++r) {
      const int zeros = static_cast<int>(r) < down_.zeros ? across_.count : across_.zeros;
      std::fill_n(sums_[r].begin(), zeros, Words{});
    }
    for (int j = 0; j < down_.run_count; ++j) {
      const ColumnRun& y = down_.runs[static_cast<std::size_t>(j)];
      for (int i = 0; i < across_.run_count; ++i) {
        const ColumnRun& x = across_.runs[static_cast<std::size_t>(i)];
        const std::uint64_t* from =
            table.tile(reader, x.tile, y.tile) + 3 * (y.offset * kTileSide + x.offset);
        for (int r = 0; r < y.count; ++r, from += 3 * kTileSide) {
          const std::size_t row = static_cast<std::size_t>(y.first) + static_cast<std::size_t>(r);
          std::uint64_t* to = sums_[row][static_cast<std::size_t>(x.first)].data();
          if (x.count == order + 1) {  // a knot by itself: a copy of known size
            std::copy_n(from, 3 * (order + 1), to);
          } else {
            std::copy_n(from, 3 * x.count, to);
          }
        }
      }
    }
  }

  // Whole rows at once; the anchor's own are not looked at again. `next` is what takes `continued` one row
  // on, so that only a gap between rows costs a multiplication.
  void take_off_above() {
    const std::size_t words = 3 * columns();
    const std::uint64_t* last = sums_[order - 1].front().data();
    const std::uint64_t* before = sums_[std::max(order - 2, 0)].front().data();
    const std::uint64_t* first = sums_[0].front().data();
    Row slope;
    Row bend;
    Row next;
    Row continued;
    for (std::size_t at = 0; at < words; ++at) {
      slope[at] = last[at] - before[at];
      bend[at] = slope[at] - before[at] + first[at];
    }
    for (std::size_t r = order; r < rows(); ++r) {
      std::uint64_t* row = sums_[r].front().data();
      const std::uint64_t d = distance<order>(down_, r);
      if (r > order && d == distance<order>(down_, r - 1) + 1) {
        for (std::size_t at = 0; at < words; ++at) {
          if constexpr (order >= 2) continued[at] += next[at];
          if constexpr (order == 3) next[at] += bend[at];
          row[at] -= continued[at];
        }
        continue;
      }
      const std::uint64_t dd = d * (d + 1) / 2;
      for (std::size_t at = 0; at < words; ++at) {
        continued[at] = last[at];
        if constexpr (order >= 2) continued[at] += d * slope[at];
        if constexpr (order == 3) continued[at] += dd * bend[at];
        next[at] = slope[at];
        if constexpr (order == 3) next[at] += (d + 1) * bend[at];
        row[at] -= continued[at];
      }
    }
  }

  // Takes off what lies to the left, which leaves the sums over the block, and weighs them.
  void add_to(std::array<double, 3>& total) const {
    std::array<std::uint64_t, kMost> d{};
    std::array<std::uint64_t, kMost> dd{};
    for (std::size_t c = order; c < columns(); ++c) {
      d[c] = distance<order>(across_, c);
      dd[c] = d[c] * (d[c] + 1) / 2;
    }
    for (std::size_t r = order; r < rows(); ++r) {
      const auto& row = sums_[r];
      const Words& last = row[order - 1];
      const Words& before = row[std::max(order - 2, 0)];
      Words slope;
      Words bend;
      for (std::size_t k = 0; k < 3; ++k) {
        slope[k] = last[k] - before[k];
        bend[k] = slope[k] - before[k] + row[0][k];
      }
      // Three sums side by side: one would wait for each addition.
      std::array<double, 3> weighed{};
      for (std::size_t c = order; c < columns(); ++c) {
        for (std::size_t k = 0; k < 3; ++k) {
          std::uint64_t sum = row[c][k] - last[k];
          if constexpr (order >= 2) sum -= d[c] * slope[k];
          if constexpr (order == 3) sum -= dd[c] * bend[k];
          weighed[k] += across_.weight[c] * static_cast<double>(static_cast<std::int64_t>(sum));
        }
      }
      for (std::size_t k = 0; k < 3; ++k) total[k] += down_.weight[r] * weighed[k];
    }
  }

 private:
  static constexpr std::size_t kMost = (order + 1) * (order + 3);
  using Row = std::array<std::uint64_t, 3 * kMost>;

  std::size_t columns() const { return static_cast<std::size_t>(across_.count); }
  std::size_t rows() const { return static_cast<std::size_t>(down_.count); }

  const AxisPiece& across_;
  const AxisPiece& down_;
  std::array<std::array<Words, kMost>, kMost> sums_;
};

template <int order>
void add_block_of(const IntegralTable& table, const AxisPiece& across, const AxisPiece& down,
                  TileReader& reader, std::array<double, 3>& total) {
  Block<order> block(across, down);
  block.load(table, reader);
  block.take_off_above();
  block.add_to(total);
}

}  // namespace

void add_block(const IntegralTable& table, int order, const AxisPiece& across, const AxisPiece& down,
               TileReader& reader, std::array<double, 3>& total) {
  if (order == 1) add_block_of<1>(table, across, down, reader, total);
  if (order == 2) add_block_of<2>(table, across, down, reader, total);
  if (order == 3) add_block_of<3>(table, across, down, reader, total);
}

}  // namespace sweepkit::texmap
