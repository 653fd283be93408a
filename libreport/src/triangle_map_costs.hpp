// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "counting_number.hpp"
#include "sweepkit/texmap/triangle_maps.hpp"
#include "timing.hpp"
#include "triangle_map_errors.hpp"

namespace sweepkit::report {

/// What one method takes, in the order of kMapNames.
struct MapCost {
  texmap::OperationCounts prepare, hit;
  std::size_t float_bytes = 0;  ///< kept for a triangle besides its own corners
  std::size_t double_bytes = 0;
};
std::array<MapCost, kMapNames.size()> map_costs();

/// For one triangle and for one hit.
struct MapTimings {
  std::array<Timing, kMapNames.size()> prepare, hit;
};

/// On the first 1,024 pairs, which fit into the first cache whatever is kept.
template <class Real>
MapTimings time_maps(const CaseMaker<Real>& make, const Effort& effort);

}  // namespace sweepkit::report
