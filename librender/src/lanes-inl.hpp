// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Sixteen floats on any instruction set: one vector of 16 lanes, two of 8, four of 4 or sixteen of one. For
// inclusion once an instruction set, between Highway's namespace macros (hence no usual include guard).

#if defined(SWEEPKIT_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWEEPKIT_LANES_INL
#undef SWEEPKIT_LANES_INL
#else
#define SWEEPKIT_LANES_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace sweepkit::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, 16>;
inline constexpr std::size_t kPartLanes = hn::MaxLanes(FloatTag());
inline constexpr std::size_t kParts = 16 / kPartLanes;

struct Lanes {
  hn::Vec<FloatTag> part[kParts];
};

HWY_INLINE Lanes set(float value) {
  Lanes out;
  for (auto& part : out.part) part = hn::Set(FloatTag(), value);
  return out;
}

HWY_INLINE Lanes load(const float* HWY_RESTRICT from) {
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k) out.part[k] = hn::LoadU(FloatTag(), from + k * kPartLanes);
  return out;
}

HWY_INLINE void store(const Lanes& lanes, float* HWY_RESTRICT to) {
  for (std::size_t k = 0; k < kParts; ++k) hn::StoreU(lanes.part[k], FloatTag(), to + k * kPartLanes);
}

/// base[index[lane]]
HWY_INLINE Lanes gather(const float* HWY_RESTRICT base, const std::int32_t* HWY_RESTRICT index) {
  const hn::RebindToSigned<FloatTag> integers;
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k) {
    out.part[k] = hn::GatherIndex(FloatTag(), base, hn::LoadU(integers, index + k * kPartLanes));
  }
  return out;
}

/// `value` in that lane.
HWY_INLINE Lanes with_lane(Lanes lanes, std::uint32_t lane, float value) {
  const hn::RebindToSigned<FloatTag> integers;
  for (std::size_t k = 0; k < kParts; ++k) {
    const auto index = hn::Iota(integers, static_cast<std::int32_t>(k * kPartLanes));
    const auto is_it =
        hn::RebindMask(FloatTag(), hn::Eq(index, hn::Set(integers, static_cast<std::int32_t>(lane))));
    lanes.part[k] = hn::IfThenElse(is_it, hn::Set(FloatTag(), value), lanes.part[k]);
  }
  return lanes;
}

HWY_INLINE Lanes operator-(const Lanes& a, const Lanes& b) {
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k) out.part[k] = hn::Sub(a.part[k], b.part[k]);
  return out;
}

HWY_INLINE Lanes operator+(const Lanes& a, const Lanes& b) {
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k) out.part[k] = hn::Add(a.part[k], b.part[k]);
  return out;
}

HWY_INLINE Lanes operator*(const Lanes& a, const Lanes& b) {
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k) out.part[k] = hn::Mul(a.part[k], b.part[k]);
  return out;
}

/// a * b + c, rounded once or twice: only what may be either is computed with it.
HWY_INLINE Lanes multiply_add(const Lanes& a, const Lanes& b, const Lanes& c) {
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k) out.part[k] = hn::MulAdd(a.part[k], b.part[k], c.part[k]);
  return out;
}

/// a * b - c * d, the same.
HWY_INLINE Lanes difference_of_products(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k)
    out.part[k] = hn::NegMulAdd(c.part[k], d.part[k], hn::Mul(a.part[k], b.part[k]));
  return out;
}

HWY_INLINE Lanes min(const Lanes& a, const Lanes& b) {
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k) out.part[k] = hn::Min(a.part[k], b.part[k]);
  return out;
}

HWY_INLINE Lanes max(const Lanes& a, const Lanes& b) {
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k) out.part[k] = hn::Max(a.part[k], b.part[k]);
  return out;
}

HWY_INLINE Lanes operator/(const Lanes& a, const Lanes& b) {
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k) out.part[k] = hn::Div(a.part[k], b.part[k]);
  return out;
}

HWY_INLINE Lanes copy_sign(const Lanes& size, const Lanes& sign) {
  Lanes out;
  for (std::size_t k = 0; k < kParts; ++k) out.part[k] = hn::CopySign(size.part[k], sign.part[k]);
  return out;
}

/// The greatest of all.
HWY_INLINE float greatest(const Lanes& lanes) {
  auto part = lanes.part[0];
  for (std::size_t k = 1; k < kParts; ++k) part = hn::Max(part, lanes.part[k]);
  return hn::GetLane(hn::MaxOfLanes(FloatTag(), part));
}

HWY_INLINE std::uint32_t bits_of(hn::Mask<FloatTag> mask) {
  alignas(8) std::uint8_t bytes[8];
  const std::size_t count = hn::StoreMaskBits(FloatTag(), mask, bytes);
  if (count < 2) return bytes[0];
  std::uint16_t bits;
  std::memcpy(&bits, bytes, sizeof bits);  // x86, ARM and WebAssembly: the low byte comes first
  return bits;
}

/// Bit by lane: is a <= b? NaN is not.
HWY_INLINE std::uint32_t less_equal(const Lanes& a, const Lanes& b) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < kParts; ++k) bits |= bits_of(hn::Le(a.part[k], b.part[k])) << (k * kPartLanes);
  return bits;
}

/// Bit by lane: a < b and c > d? NaN is not.
HWY_INLINE std::uint32_t less_and_greater(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < kParts; ++k) {
    bits |= bits_of(hn::And(hn::Lt(a.part[k], b.part[k]), hn::Gt(c.part[k], d.part[k]))) << (k * kPartLanes);
  }
  return bits;
}

/// For every lane of `bits` the bits of its float, the last four of them replaced by the lane; packed, and at
/// least the first four of the rest 0.
HWY_INLINE std::uint32_t pack_keys(const Lanes& lanes, std::uint32_t bits, std::uint32_t keys[16]) {
#if HWY_MAX_BYTES == 64
  const hn::RebindToUnsigned<FloatTag> integers;
  const auto packed = static_cast<std::uint16_t>(bits);
  const auto mask = hn::LoadMaskBits(integers, reinterpret_cast<const std::uint8_t*>(&packed));
  const auto all =
      hn::Or(hn::AndNot(hn::Set(integers, 15u), hn::BitCast(integers, lanes.part[0])), hn::Iota(integers, 0));
  hn::Store(hn::Compress(hn::IfThenElseZero(mask, all), mask), integers, keys);
  return static_cast<std::uint32_t>(std::popcount(bits));
#else
  alignas(64) float values[16];
  store(lanes, values);
  std::fill_n(keys, 4, 0);
  std::uint32_t count = 0;
  for (; bits != 0; bits &= bits - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(bits));
    keys[count++] = (std::bit_cast<std::uint32_t>(values[lane]) & ~15u) | lane;
  }
  return count;
#endif
}

/// Lane k + kStep in lane k; what comes after the last is of no use.
template <std::uint32_t kStep>
HWY_INLINE Lanes later(const Lanes& lanes) {
#if HWY_MAX_BYTES == 64
  alignas(64) static constexpr auto kFrom = [] {
    std::array<std::int32_t, 16> from{};
    for (std::uint32_t k = 0; k < 16; ++k) from[k] = static_cast<std::int32_t>((k + kStep) % 16);
    return from;
  }();
  return {{hn::TableLookupLanes(lanes.part[0], hn::SetTableIndices(FloatTag(), kFrom.data()))}};
#else
  alignas(64) float buffer[32];
  store(lanes, buffer);
  store(lanes, buffer + 16);
  return load(buffer + kStep);
#endif
}

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
