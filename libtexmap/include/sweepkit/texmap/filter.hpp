// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace sweepkit::texmap {

/// How a texture is looked up under a pixel's footprint. All but kBox are meant for a pixel filter that is a
/// tent of one pixel each way.
enum class Filter {
  kPoint,      ///< the texel at the middle
  kBilinear,   ///< interpolated between the texels there
  kTrilinear,  ///< a MIP pyramid, isotropic [Williams83]
  kIntegral1,  ///< a box over the footprint, from a summed-area table [Crow84]
  kIntegral2,  ///< two boxes convolved, a tent, from a table of order 2 [Heckbert86]
  kIntegral3,  ///< three boxes convolved, from a table of order 3
  kEwa,        ///< the elliptical weighted average [Heckbert89]
  kBox,        ///< the mean under the pixel itself: for a pixel filter that is a box of one pixel
  kAuto,       ///< bilinear where the texture is magnified; elsewhere the elliptical average, from coarser
               ///< levels the longer the footprint (docs/plane_filters.md)
};

/// Does the filter look at more than the middle of a footprint?
constexpr bool reads_footprint(Filter filter) {
  return filter != Filter::kPoint && filter != Filter::kBilinear;
}
/// Does it read a table of integrals (else tiles)?
constexpr bool reads_table(Filter filter) {
  return filter == Filter::kIntegral1 || filter == Filter::kIntegral2 || filter == Filter::kIntegral3;
}

/// Their names, in order: "point", "bilinear", ...
inline constexpr std::array<std::string_view, 9> kFilterNames = {
    "point", "bilinear", "trilinear", "integral-1", "integral-2", "integral-3", "ewa", "box", "auto"};
inline constexpr std::string_view filter_name(Filter filter) {
  return kFilterNames[static_cast<std::size_t>(filter)];
}

}  // namespace sweepkit::texmap
