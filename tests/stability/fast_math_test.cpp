// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What -ffast-math breaks: curves, frames and triangle maps are compiled with it (CMakeLists.txt), the judges
// are not.

#include <gtest/gtest.h>

#include <set>

#include "stability/stability_case.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::report {
namespace {

std::set<std::string> broken() {
  std::set<std::string> names;
  for (const auto& stage :
       {curve_cases, length_stability_cases, frame_cases, sweep_cases, triangle_map_cases, ray_cases}) {
    for (const StabilityCase& one : stage()) {
      try {
        const Reached reached = one.run();
        if (verdict_of(one, reached) == Verdict::kFail) names.insert(one.name);
      } catch (const InputError&) {
        names.insert(one.name);
      }
    }
  }
  return names;
}

// Checks for NaN and infinity are folded away, so what is no number is taken; the bounds on finite input
// hold.
TEST(FastMath, TakesNumbersThatAreNone) {
  EXPECT_EQ(broken(), (std::set<std::string>{"sweeps_refused_law", "sweeps_refused_bezier_law",
                                             "sweeps_refused_law_points"}));
}

}  // namespace
}  // namespace sweepkit::report
