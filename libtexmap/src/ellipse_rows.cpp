// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Four texels at a time, which are sixteen floats: one vector of 16 lanes, two of 8, four of 4, or sixteen
// of one, whatever the machine has, with a weight to every lane. A row's texels are taken past both ends of
// its span, as many in every row of a narrow ellipse: that costs no branch, and those beside the ellipse
// weigh nothing, whatever they are (integers are never NaN). No products and sums are fused, so every machine
// finds the same.

#include "ellipse_rows.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ellipse_rows.cpp"
#include <hwy/foreach_target.h>
// Behind the above, which includes this file once an instruction set.
#include <hwy/highway.h>

#include <algorithm>

#include "pyramid.hpp"

HWY_BEFORE_NAMESPACE();
namespace sweepkit::texmap::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, 16>;
using IntTag = hn::RebindToSigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
inline constexpr std::size_t kLanes = hn::MaxLanes(FloatTag());
inline constexpr std::size_t kParts = 16 / kLanes;

void find_spans(const EllipseRows& ellipse, Spans& spans) {
  const FloatTag tag;
  const IntTag integers;
  const std::size_t room = static_cast<std::size_t>(ellipse.count) + kLanes;
  if (spans.first.size() < room) {
    spans.first.resize(room);
    spans.last.resize(room);
    spans.top.resize(room);
    spans.middle.resize(room);
  }
  const Floats one = hn::Set(tag, 1.0f);
  const Floats per_height = hn::Set(tag, ellipse.per_height);
  const Floats across = hn::Set(tag, ellipse.across);
  const auto last_column = hn::Set(integers, ellipse.last_column);
  auto widest = hn::Zero(integers);
  for (int k = 0; k < ellipse.count; k += static_cast<int>(kLanes)) {
    const Floats row = hn::ConvertTo(tag, hn::Iota(integers, k));
    const Floats dy = hn::Add(hn::Set(tag, ellipse.first_dy), row);
    const Floats top = hn::Max(hn::Sub(one, hn::Mul(hn::Mul(dy, dy), per_height)), hn::Zero(tag));
    const Floats middle = hn::Add(hn::Set(tag, ellipse.middle), hn::Mul(hn::Set(tag, ellipse.slope), dy));
    const Floats half = hn::Sqrt(hn::Mul(top, across));
    const auto first = hn::ConvertTo(integers, hn::Sub(middle, half));
    const auto last = hn::Min(hn::ConvertTo(integers, hn::Add(middle, half)), last_column);
    widest = hn::Max(widest, hn::Sub(last, first));
    hn::StoreU(first, integers, spans.first.data() + k);
    hn::StoreU(last, integers, spans.last.data() + k);
    hn::StoreU(top, tag, spans.top.data() + k);
    hn::StoreU(middle, tag, spans.middle.data() + k);
  }
  spans.most_fours = (hn::GetLane(hn::MaxOfLanes(integers, widest)) + 4) / 4;
}

// The four texels at `texels` as floats, lanes part * kLanes and on.
HWY_INLINE Floats texels_at(const std::uint16_t* HWY_RESTRICT texels, std::size_t part) {
  const hn::Rebind<std::uint16_t, FloatTag> shorts;
  return hn::ConvertTo(FloatTag(), hn::PromoteTo(IntTag(), hn::LoadU(shorts, texels + part * kLanes)));
}

// kFours in every row, or, for 0, as many as the row takes.
template <bool kIsPart, int kFours>
HWY_INLINE void add_rows_of(const TileRows& rows, const Spans& spans, EllipseSum& sum) {
  const FloatTag tag;
  alignas(64) static constexpr float kTexelOfLane[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
  Floats sums[kParts];
  Floats texel_of_lane[kParts];
  for (std::size_t p = 0; p < kParts; ++p) {
    sums[p] = hn::LoadU(tag, sum.lanes + p * kLanes);
    texel_of_lane[p] = hn::LoadU(tag, kTexelOfLane + p * kLanes);
  }
  const Floats steepness = hn::Set(tag, rows.steepness);
  const Floats from = hn::Set(tag, static_cast<float>(rows.first_column));
  const Floats to = hn::Set(tag, static_cast<float>(rows.last_column));
  const auto* tile_row = reinterpret_cast<const std::uint16_t*>(rows.texels);
  const std::int32_t* HWY_RESTRICT firsts = spans.first.data() + rows.first_row;
  const std::int32_t* HWY_RESTRICT lasts = spans.last.data() + rows.first_row;
  const float* HWY_RESTRICT tops = spans.top.data() + rows.first_row;
  const float* HWY_RESTRICT middles = spans.middle.data() + rows.first_row;
  for (int k = 0; k < rows.count; ++k, tile_row += 4 * rows.next_row) {
    int first = firsts[k];
    if (kIsPart) first = std::max(first, rows.first_column);
    int fours = kFours;
    if (kFours == 0) {
      const int last = kIsPart ? std::min(lasts[k], rows.last_column) : lasts[k];
      fours = (last - first + 4) / 4;
    }
    // None reaches past the row's end.
    const int start = std::min(rows.offset + first, kTileSide - 4 * fours);
    const std::uint16_t* HWY_RESTRICT texels = tile_row + 4 * start;
    const Floats top = hn::Set(tag, tops[k]);
    const Floats middle = hn::Set(tag, middles[k]);
    Floats begin = hn::Set(tag, static_cast<float>(start - rows.offset));
    for (int i = 0; i < fours; ++i, texels += 16) {
      for (std::size_t p = 0; p < kParts; ++p) {
        const Floats column = hn::Add(begin, texel_of_lane[p]);
        const Floats dx = hn::Sub(column, middle);
        Floats root = hn::Max(hn::Sub(top, hn::Mul(hn::Mul(dx, dx), steepness)), hn::Zero(tag));
        if (kIsPart) {
          root = hn::IfThenElseZero(hn::And(hn::Ge(column, from), hn::Le(column, to)), root);
        }
        sums[p] = hn::Add(sums[p], hn::Mul(hn::Mul(root, root), texels_at(texels, p)));
      }
      begin = hn::Add(begin, hn::Set(tag, 4.0f));
    }
  }
  for (std::size_t p = 0; p < kParts; ++p) hn::StoreU(sums[p], tag, sum.lanes + p * kLanes);
}

template <bool kIsPart>
HWY_INLINE void add_rows_of(const TileRows& rows, const Spans& spans, EllipseSum& sum) {
  switch (spans.most_fours) {
    case 1:
      return add_rows_of<kIsPart, 1>(rows, spans, sum);
    case 2:
      return add_rows_of<kIsPart, 2>(rows, spans, sum);
    default:
      return add_rows_of<kIsPart, 0>(rows, spans, sum);
  }
}

void add_rows(const TileRows& rows, const Spans& spans, EllipseSum& sum) {
  if (rows.is_part) {
    add_rows_of<true>(rows, spans, sum);
  } else {
    add_rows_of<false>(rows, spans, sum);
  }
}

EllipseKernels kernels() {
  return {find_spans, add_rows};
}

}  // namespace sweepkit::texmap::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sweepkit::texmap {

HWY_EXPORT(kernels);

namespace {

const EllipseKernels& best_kernels() {
  static const EllipseKernels best = HWY_DYNAMIC_DISPATCH(kernels)();
  return best;
}

}  // namespace

void find_spans(const EllipseRows& ellipse, Spans& spans) {
  best_kernels().find_spans(ellipse, spans);
}

void add_rows(const TileRows& rows, const Spans& spans, EllipseSum& sum) {
  best_kernels().add_rows(rows, spans, sum);
}

std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
    names.emplace_back(hwy::TargetName(target));
  return names;
}

EllipseKernels ellipse_kernels(const std::string& instruction_set) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (instruction_set != hwy::TargetName(target)) continue;
    hwy::ChosenTarget chosen;
    chosen.Update(target);
    return HWY_DISPATCH_TABLE(kernels)[chosen.GetIndex()]();
  }
  return {};
}

}  // namespace sweepkit::texmap
#endif
