// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// ShearedRay::meets() for several rays of one origin and triangles of one leaf at once: the same operations
// in the same order, so the same to the bit. For inclusion once an instruction set, as lanes-inl.hpp.

#if defined(SWEEPKIT_EXACT_TEST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWEEPKIT_EXACT_TEST_INL
#undef SWEEPKIT_EXACT_TEST_INL
#else
#define SWEEPKIT_EXACT_TEST_INL
#endif

#include <cstdint>

#include "lanes-inl.hpp"
#include "triangle_intersection.hpp"

HWY_BEFORE_NAMESPACE();
namespace sweepkit::render::HWY_NAMESPACE {

using RayTag = hn::CappedTag<double, 8>;
using RayLanes = hn::Vec<RayTag>;
inline constexpr std::size_t kRayLanes = hn::MaxLanes(RayTag());

/// What is left of a leaf's triangles for float32: ray and bit of the leaf, as triangle_of() has them.
struct Survivors {
  static constexpr std::uint32_t kMost = 16 * 32;
  std::uint32_t count = 0;
  alignas(64) std::int32_t rays[kMost + 16];  // 16 more are written and read, not looked at
  alignas(64) std::int32_t bits[kMost + 16];

  HWY_INLINE void add(std::uint32_t ray, std::uint32_t left) {
    // One is often all there is: no branch that depends on whether there is one.
    rays[count] = static_cast<std::int32_t>(ray);
    bits[count] = std::countr_zero(left | 1u << 31);
    count += left != 0 ? 1 : 0;
    for (left &= left - 1; HWY_UNLIKELY(left != 0); left &= left - 1) {
      rays[count] = static_cast<std::int32_t>(ray);
      bits[count++] = std::countr_zero(left);
    }
  }
};

/// The rays, axes as ShearedRay has them.
struct ExactRays {
  double origin[3];
  alignas(64) double shears[2][16];
  alignas(64) double scales[16];
};

/// Of kRayLanes survivors, by lane.
struct ExactHits {
  std::uint32_t are_hits;
  std::uint32_t are_unsure;  ///< seen so much from their edge that only ShearedRay knows
  alignas(64) double t[kRayLanes];
  alignas(64) double weights[3][kRayLanes];
};

inline std::uint32_t bits_of_rays(hn::Mask<RayTag> mask) {
  alignas(8) std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(RayTag(), mask, bytes);
  return bytes[0];
}

/// A leaf's vertices along one axis, to be looked up by lane.
#if HWY_MAX_BYTES == 64
using Corners = Lanes;
HWY_INLINE Corners to_look_up(const Lanes& lanes) {
  return lanes;
}
template <class Indices>
HWY_INLINE auto look_up(const Corners& corners, const Indices& lanes) {
  const FloatTag tag;
  const auto wide = hn::ZeroExtendVector(hn::RebindToSigned<FloatTag>(), lanes);
  return hn::LowerHalf(hn::Half<FloatTag>(),
                       hn::TableLookupLanes(corners.part[0], hn::IndicesFromVec(tag, wide)));
}
#else
struct Corners {
  alignas(64) float stored[16];
};
HWY_INLINE Corners to_look_up(const Lanes& lanes) {
  Corners corners;
  store(lanes, corners.stored);
  return corners;
}
template <class Indices>
HWY_INLINE auto look_up(const Corners& corners, const Indices& lanes) {
  return hn::GatherIndex(hn::Rebind<float, RayTag>(), corners.stored, lanes);
}
#endif

/// `corners` are the leaf's vertices by lane, each row of them kRow long; the axes as in `rays`.
template <std::uint32_t kRow>
HWY_INLINE void test_exactly(const Corners corners[3], bool is_turned, const ExactRays& rays,
                             const Survivors& survivors, std::uint32_t from, ExactHits& out) {
  const RayTag tag;
  const hn::Rebind<std::int32_t, RayTag> integers;
  const hn::RebindToSigned<RayTag> longs;
  const auto bit = hn::LoadU(integers, survivors.bits + from);

  const auto wrap = hn::Set(integers, 15);
  const auto is_upper = hn::Gt(bit, wrap);
  const auto lane = hn::And(bit, wrap);  // what is not looked at, too, is in the leaf
  const auto beside = hn::Add(lane, hn::Set(integers, 1));
  const auto above = hn::Add(lane, hn::Set(integers, std::int32_t{kRow}));
  const auto is_first_beside = hn::Gt(hn::Xor(bit, hn::Set(integers, is_turned ? 16 : 0)), wrap);
  const decltype(lane) vertices[3] = {
      hn::And(hn::IfThenElse(is_first_beside, beside, above), wrap),
      hn::And(hn::IfThenElse(is_upper, hn::Add(above, hn::Set(integers, 1)), lane), wrap),
      hn::And(hn::IfThenElse(is_first_beside, above, beside), wrap)};
  const auto ray = hn::PromoteTo(longs, hn::And(hn::LoadU(integers, survivors.rays + from), wrap));
  const RayLanes shear_x = hn::GatherIndex(tag, rays.shears[0], ray);
  const RayLanes shear_y = hn::GatherIndex(tag, rays.shears[1], ray);
  RayLanes px[3];
  RayLanes py[3];
  RayLanes pz[3];
  for (int k = 0; k < 3; ++k) {
    const auto coordinate = [&](int axis) HWY_ATTR {
      const auto read = look_up(corners[axis], vertices[k]);
      return hn::Sub(hn::PromoteTo(tag, read), hn::Set(tag, rays.origin[axis]));
    };
    pz[k] = coordinate(2);
    px[k] = hn::Sub(coordinate(0), hn::Mul(shear_x, pz[k]));
    py[k] = hn::Sub(coordinate(1), hn::Mul(shear_y, pz[k]));
  }
  const RayLanes cx_by = hn::Mul(px[2], py[1]);
  const RayLanes ax_cy = hn::Mul(px[0], py[2]);
  const RayLanes bx_ay = hn::Mul(px[1], py[0]);
  const RayLanes u = hn::Sub(cx_by, hn::Mul(py[2], px[1]));
  const RayLanes v = hn::Sub(ax_cy, hn::Mul(py[0], px[2]));
  const RayLanes w = hn::Sub(bx_ay, hn::Mul(py[1], px[0]));
  const RayLanes zero = hn::Zero(tag);
  const auto has_both_signs = hn::And(hn::Or(hn::Or(hn::Lt(u, zero), hn::Lt(v, zero)), hn::Lt(w, zero)),
                                      hn::Or(hn::Or(hn::Gt(u, zero), hn::Gt(v, zero)), hn::Gt(w, zero)));
  const RayLanes determinant = hn::Add(hn::Add(u, v), w);
  const RayLanes products = hn::Add(hn::Add(hn::Abs(cx_by), hn::Abs(ax_cy)), hn::Abs(bx_ay));
  const auto is_unsure =
      hn::Lt(hn::Abs(determinant), hn::Mul(hn::Set(tag, ShearedRay::kLeastShare), products));
  const RayLanes depth = hn::Add(hn::Add(hn::Mul(u, pz[0]), hn::Mul(v, pz[1])), hn::Mul(w, pz[2]));
  const RayLanes t = hn::Div(hn::Mul(hn::GatherIndex(tag, rays.scales, ray), depth), determinant);
  // A determinant of 0 is unsure, or all products are 0: then t is not above 0, nor a number.
  const auto is_hit = hn::AndNot(hn::Or(has_both_signs, is_unsure), hn::Gt(t, zero));
  out.are_hits = bits_of_rays(is_hit);
  out.are_unsure = bits_of_rays(hn::AndNot(has_both_signs, is_unsure));
  hn::Store(t, tag, out.t);
  hn::Store(hn::Div(u, determinant), tag, out.weights[0]);
  hn::Store(hn::Div(v, determinant), tag, out.weights[1]);
  hn::Store(hn::Div(w, determinant), tag, out.weights[2]);
}

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
