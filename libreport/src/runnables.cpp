// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "curves_experiment.hpp"
#include "frames_experiment.hpp"
#include "stability_experiment.hpp"
#include "sweepkit/report/report.hpp"

namespace sweepkit::report {

const std::vector<Runnable>& runnables() {
  static const std::vector<Runnable> all = {{"curves", "Points of Bezier segments", measure_curves},
                                            {"lengths", "Arc length", measure_lengths},
                                            {"frames", "Frames along a trajectory", measure_frames},
                                            {"stability", "Stiff and extreme cases", measure_stability}};
  return all;
}

}  // namespace sweepkit::report
