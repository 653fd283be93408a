// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A grid leaf's vertices, from the mesh's rows of x, y, z into a lane each. For inclusion once an instruction
// set, as lanes-inl.hpp.

#if defined(SWEEPKIT_LEAF_VERTICES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWEEPKIT_LEAF_VERTICES_INL
#undef SWEEPKIT_LEAF_VERTICES_INL
#else
#define SWEEPKIT_LEAF_VERTICES_INL
#endif

#include <cstdint>

#include "box_tree.hpp"
#include "lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sweepkit::render::HWY_NAMESPACE {

#if HWY_MAX_BYTES == 64

/// How the rows of a shape are loaded and dealt out: row by row into vectors, two short ones into one, a long
/// one into two; then, for each vector and axis, which of its floats goes to which lane.
template <std::uint32_t kColumns, std::uint32_t kRows>
struct Deal {
  static constexpr std::uint32_t kWide = kColumns + 1;
  static constexpr std::uint32_t kHigh = kRows + 1;
  static constexpr std::uint32_t kFloats = 3 * kWide;
  static constexpr std::uint32_t kVectors = kFloats <= 8    ? (kHigh + 1) / 2
                                            : kFloats <= 16 ? kHigh
                                                            : 2 * kHigh;
  struct Table {
    alignas(64) std::int32_t from[kVectors][3][kWidth];
    std::uint16_t axis_lanes[kVectors][3];
  };
  static constexpr Table kTable = [] {
    Table table{};
    for (std::uint32_t lane = 0; lane < kWide * kHigh; ++lane) {
      const std::uint32_t row = lane / kWide;
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t at = 3 * (lane % kWide) + axis;
        const std::uint32_t vector = kFloats <= 8 ? row / 2 : kFloats <= 16 ? row : 2 * row + at / 16;
        table.from[vector][axis][lane] =
            static_cast<std::int32_t>(kFloats <= 8 ? 8 * (row % 2) + at : at % 16);
        table.axis_lanes[vector][axis] |= static_cast<std::uint16_t>(1u << lane);
      }
    }
    return table;
  }();
};

/// Nothing past a row's last float is read: there may be no memory.
template <std::uint32_t kColumns, std::uint32_t kRows>
HWY_INLINE void load_vertices(const float* HWY_RESTRICT from, const LeafGrid& grid, const int axes[3],
                              Lanes out[3]) {
  using D = Deal<kColumns, kRows>;
  const FloatTag tag;
  const std::size_t stride = 3 * std::size_t{grid.stride};
  hn::Vec<FloatTag> vectors[D::kVectors];
  for (std::uint32_t k = 0; k < D::kVectors; ++k) {
    if constexpr (D::kFloats <= 8) {
      const hn::Half<FloatTag> half;
      const auto first = hn::FirstN(half, D::kFloats);
      const auto low = hn::MaskedLoad(first, half, from + 2 * k * stride);
      const auto high = 2 * k + 1 < D::kHigh ? hn::MaskedLoad(first, half, from + (2 * k + 1) * stride) : low;
      vectors[k] = hn::Combine(tag, high, low);
    } else if constexpr (D::kFloats <= 16) {
      vectors[k] = hn::MaskedLoad(hn::FirstN(tag, D::kFloats), tag, from + k * stride);
    } else {
      const float* row = from + k / 2 * stride;
      vectors[k] =
          k % 2 == 0 ? hn::LoadU(tag, row) : hn::MaskedLoad(hn::FirstN(tag, D::kFloats - 16), tag, row + 16);
    }
  }
  const hn::RebindToSigned<FloatTag> integers;
  for (int n = 0; n < 3; ++n) {
    const auto axis = static_cast<std::size_t>(axes[n]);
    auto dealt = hn::TableLookupLanes(vectors[0],
                                      hn::IndicesFromVec(tag, hn::Load(integers, D::kTable.from[0][axis])));
    for (std::uint32_t k = 1; k < D::kVectors; ++k) {
      const auto lanes =
          hn::LoadMaskBits(tag, reinterpret_cast<const std::uint8_t*>(&D::kTable.axis_lanes[k][axis]));
      dealt = hn::IfThenElse(
          lanes,
          hn::TableLookupLanes(vectors[k],
                               hn::IndicesFromVec(tag, hn::Load(integers, D::kTable.from[k][axis]))),
          dealt);
    }
    out[n].part[0] = dealt;
  }
}

#else

template <std::uint32_t kColumns, std::uint32_t kRows>
HWY_INLINE void load_vertices(const float* HWY_RESTRICT from, const LeafGrid& grid, const int axes[3],
                              Lanes out[3]) {
  for (int n = 0; n < 3; ++n) out[n] = gather(from + axes[n], grid.offsets.data());
}

#endif

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
