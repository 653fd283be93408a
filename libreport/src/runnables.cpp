// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "accelerators_experiment.hpp"
#include "curves_experiment.hpp"
#include "filters_experiment.hpp"
#include "frames_experiment.hpp"
#include "leaving_out_experiment.hpp"
#include "pictures_experiment.hpp"
#include "scale_experiment.hpp"
#include "stability_experiment.hpp"
#include "sweepkit/report/report.hpp"
#include "tessellation_experiment.hpp"
#include "triangle_maps_experiment.hpp"

namespace sweepkit::report {

const std::vector<Runnable>& runnables() {
  static const std::vector<Runnable> all = {
      {"curves", "Points of Bezier segments", measure_curves},
      {"lengths", "Arc length", measure_lengths},
      {"frames", "Frames along a trajectory", measure_frames, true},
      {"tessellation", "Cells of a mesh", measure_tessellation},
      {"triangle_maps", "From a hit on a triangle to its texture coordinates", measure_triangle_maps},
      {"filters", "Texture filters", measure_filters},
      {"pictures", "Whole pictures", measure_pictures, true},
      {"accelerators", "Accelerators", measure_accelerators},
      {"scale", "Time and memory against size", measure_scale},
      {"leaving_out", "What a scene does without", measure_leaving_out, true},
      {"stability", "Stiff and extreme cases", measure_stability}};
  return all;
}

}  // namespace sweepkit::report
