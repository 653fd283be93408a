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

#include <cstdint>

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

HWY_INLINE std::uint32_t bits_of(hn::Mask<FloatTag> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(FloatTag(), mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
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

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
