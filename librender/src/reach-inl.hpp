// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Makes a CullingRay of a ray, x, y and z at once. For inclusion once an instruction set, as lanes-inl.hpp.
//
// Without a branch that depends on the ray's direction: there is no predicting one, and each costs as much as
// the box test.

#if defined(SWEEPKIT_REACH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWEEPKIT_REACH_INL
#undef SWEEPKIT_REACH_INL
#else
#define SWEEPKIT_REACH_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "culling_ray.hpp"
#include "ray.hpp"
#include "triangle_intersection.hpp"

HWY_BEFORE_NAMESPACE();
namespace sweepkit::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DoubleTag = hn::CappedTag<double, 4>;
inline constexpr std::size_t kAxisLanes = hn::MaxLanes(DoubleTag());
inline constexpr std::size_t kAxisParts = 4 / kAxisLanes;

/// x, y, z and a fourth that is of no use.
struct Axes {
  hn::Vec<DoubleTag> part[kAxisParts];
};

template <class Function>
HWY_INLINE Axes axes_of(const Function& function) {
  Axes out;
  for (std::size_t k = 0; k < kAxisParts; ++k) out.part[k] = function(k);
  return out;
}

HWY_INLINE Axes load_axes(const double* from) {
  return axes_of([&](std::size_t k) HWY_ATTR { return hn::LoadU(DoubleTag(), from + k * kAxisLanes); });
}

HWY_INLINE Reach reach(const Ray& ray, const BoxTree& tree, CullingRay& out) {
  const DoubleTag tag;
  const double* const o = glm::value_ptr(ray.origin);
  const double* const d = glm::value_ptr(ray.direction);
  const double largest = std::max(std::max(std::abs(d[0]), std::abs(d[1])), std::abs(d[2]));
  const double farthest = std::max(std::max(std::abs(o[0]), std::abs(o[1])), std::abs(o[2]));
  // NaN wherever a component is NaN or infinite, and so out of bounds.
  const double spoiled = 0 * (d[0] + d[1] + d[2] + o[0] + o[1] + o[2]);
  if (!(largest + spoiled > 0x1p-300 && largest < 0x1p300 && farthest < 0x1p100)) return Reach::kUnusual;

  // Far more than double rounds to: 2^-53 times a few; and ShearedRay's 2^-26 of the largest triangle.
  const double double_error = 0x1p-46 * (farthest + tree.reach);
  const auto margin = hn::Set(tag, double_error + 2 * kFloatRounding * tree.reach);
  // The fourth component lies inside of a box of its own and keeps still.
  alignas(32) const double padded[4][4] = {{o[0], o[1], o[2], 0},
                                           {d[0], d[1], d[2], 0},
                                           {tree.box.low.x, tree.box.low.y, tree.box.low.z, -1},
                                           {tree.box.high.x, tree.box.high.y, tree.box.high.z, 1}};
  const Axes origin = load_axes(padded[0]);
  const auto scale = hn::Set(tag, 1 / largest);
  const Axes given = load_axes(padded[1]);
  const Axes direction = axes_of([&](std::size_t k) HWY_ATTR { return hn::Mul(given.part[k], scale); });
  // A direction along the box's faces is turned by so little that it moves nothing by double_error.
  const Axes inverse = axes_of([&](std::size_t k) HWY_ATTR {
    const auto size = hn::Max(hn::Abs(direction.part[k]), hn::Set(tag, 0x1p-56));
    return hn::Div(hn::Set(tag, 1), hn::CopySign(size, direction.part[k]));
  });
  const Axes low = load_axes(padded[2]);
  const Axes high = load_axes(padded[3]);
  alignas(32) double near[4];
  alignas(32) double far[4];
  for (std::size_t k = 0; k < kAxisParts; ++k) {
    const auto to_low = hn::Mul(hn::Sub(hn::Sub(low.part[k], margin), origin.part[k]), inverse.part[k]);
    const auto to_high = hn::Mul(hn::Sub(hn::Add(high.part[k], margin), origin.part[k]), inverse.part[k]);
    hn::StoreU(hn::Min(to_low, to_high), tag, near + k * kAxisLanes);
    hn::StoreU(hn::Max(to_low, to_high), tag, far + k * kAxisLanes);
  }
  const double enter = std::max(std::max(near[0], near[1]), std::max(near[2], 0.0));
  const double leave = std::min(std::min(far[0], far[1]), far[2]);
  if (!(enter <= leave)) return Reach::kMisses;

  const double error = 4 * double_error;
  const double moved = 24 * kFloatRounding * tree.reach + error;
  alignas(32) double at[4];
  alignas(32) double slopes[4];
  alignas(32) double near_shifts[4];
  alignas(32) double far_shifts[4];
  for (std::size_t k = 0; k < kAxisParts; ++k) {
    const auto point = hn::Add(origin.part[k], hn::Mul(hn::Set(tag, enter), direction.part[k]));
    // Turned by at most 2u: that moves the ray by 2u of the mesh's size.
    const auto slope = hn::Min(hn::Max(inverse.part[k], hn::Set(tag, -0x1p23)), hn::Set(tag, 0x1p23));
    const auto outwards = hn::CopySign(hn::Set(tag, moved), slope);
    hn::StoreU(point, tag, at + k * kAxisLanes);
    hn::StoreU(slope, tag, slopes + k * kAxisLanes);
    hn::StoreU(hn::Neg(hn::Mul(hn::Add(point, outwards), slope)), tag, near_shifts + k * kAxisLanes);
    hn::StoreU(hn::Neg(hn::Mul(hn::Sub(point, outwards), slope)), tag, far_shifts + k * kAxisLanes);
  }
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const auto is_backward = static_cast<std::uint32_t>(std::signbit(slopes[axis]));
    out.near_plane[axis] = kWidth * (axis + 3 * is_backward);
    out.far_plane[axis] = kWidth * (axis + 3 * (1 - is_backward));
    out.inverse[axis] = static_cast<float>(slopes[axis]);
    out.near_shift[axis] = static_cast<float>(near_shifts[axis]);
    out.far_shift[axis] = static_cast<float>(far_shifts[axis]);
    out.entry[axis] = at[axis];
  }
  out.shear_error = static_cast<float>(10 * kFloatRounding * tree.extent + error);
  out.scale = largest;
  out.start = enter;
  out.slack = 4 * moved;
  return Reach::kMayHit;
}

/// The rest, for a ray that enters the box.
HWY_INLINE void set_shear(const ShearedRay& sheared, CullingRay& out) {
  const int axes[3] = {sheared.x(), sheared.y(), sheared.z()};
  const double shears[2] = {sheared.shear_x(), sheared.shear_y()};
  double lost[3];
  for (int k = 0; k < 3; ++k) {
    const double at = out.entry[axes[k]];
    out.axes[k] = axes[k];
    out.origin[k] = static_cast<float>(at);
    lost[k] = static_cast<double>(out.origin[k]) - at;
  }
  for (int k = 0; k < 2; ++k) {
    out.shear[k] = static_cast<float>(-shears[k]);
    out.lost[k] = static_cast<float>(lost[k] - shears[k] * lost[2]);
  }
}

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
