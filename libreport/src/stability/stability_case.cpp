// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "stability/stability_case.hpp"

#include <limits>

namespace sweepkit::report {

Verdict verdict_of(const StabilityCase& one, const Reached& reached) {
  const bool is_kept = reached.error <= reached.bound;  // not for NaN
  if (one.limit.empty()) return is_kept ? Verdict::kPass : Verdict::kFail;
  return is_kept ? Verdict::kFail : Verdict::kKnownLimit;
}

double over_bound(const Reached& reached) {
  if (reached.bound > 0 || std::isnan(reached.error)) return reached.error / reached.bound;
  return reached.error == 0 ? 0 : std::numeric_limits<double>::infinity();
}

const std::vector<StabilityCase>& stability_cases() {
  static const std::vector<StabilityCase> all = [] {
    std::vector<StabilityCase> cases;
    for (const auto& stage :
         {curve_cases, length_stability_cases, frame_cases, sweep_cases, triangle_map_cases, ray_cases,
          table_cases, footprint_cases, glass_cases, environment_cases, material_cases, export_cases}) {
      for (StabilityCase& one : stage()) cases.push_back(std::move(one));
    }
    return cases;
  }();
  return all;
}

}  // namespace sweepkit::report
