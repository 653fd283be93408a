// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sweepkit::report {

/// What a case came to, in the case's unit. NaN is a failure.
struct Reached {
  double error = 0;
  double bound = 0;
  /// The same computed in float32, and in double by a textbook's way that is not ours, where that shows
  /// something.
  std::optional<double> in_float;
  std::optional<double> in_double;
};

/// Input that is hard for a stage, and the promise that it is held to.
struct StabilityCase {
  std::string name;   ///< stays the same for good; letters, digits and underscores
  std::string stage;  ///< "frames"
  std::string input;
  double hardness = 1;  ///< above 0
  std::string hardness_is;
  std::string promise;
  std::string unit;  ///< of error and bound
  std::function<Reached()> run;
  std::string limit;   ///< why the bound cannot be kept; empty: it is kept
  std::string raises;  ///< why the floating-point flags are raised on the way; empty: none is
};

enum class Verdict { kPass, kFail, kKnownLimit };

/// A case with a known limit that keeps its bound after all has failed: the limit is none.
Verdict verdict_of(const StabilityCase& one, const Reached& reached);

/// Error over bound; of a bound of 0, 0 for no error and infinite for any.
double over_bound(const Reached& reached);

/// Stage after stage, in the order of the data's way. At least 60, all names different.
const std::vector<StabilityCase>& stability_cases();

// One function for each stage, in a file named for it.
std::vector<StabilityCase> curve_cases();
std::vector<StabilityCase> length_stability_cases();
std::vector<StabilityCase> frame_cases();
std::vector<StabilityCase> sweep_cases();
std::vector<StabilityCase> triangle_map_cases();
std::vector<StabilityCase> ray_cases();
std::vector<StabilityCase> table_cases();
std::vector<StabilityCase> footprint_cases();
std::vector<StabilityCase> glass_cases();
std::vector<StabilityCase> environment_cases();
std::vector<StabilityCase> material_cases();
std::vector<StabilityCase> export_cases();

/// The larger of the two; a NaN stays, whichever it is. (>= would raise the flag of invalid operations for
/// it.)
inline double worse(double a, double b) {
  return std::isnan(a) || std::isgreaterequal(a, b) ? a : b;
}

/// Half a step of double at 1: the largest relative error of one operation.
inline constexpr double kRounding = 0x1p-53;

}  // namespace sweepkit::report
