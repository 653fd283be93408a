// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "render_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "plan_table.hpp"

namespace sweepkit::tools {

void RenderTotal::add(const render::Picture& picture) {
  const render::Statistics before = statistics;
  statistics = picture.statistics;
  statistics.eye_rays += before.eye_rays;
  statistics.refined_pixels += before.refined_pixels;
  statistics.refining_rays += before.refining_rays;
  statistics.reflected_rays += before.reflected_rays;
  statistics.refracted_rays += before.refracted_rays;
  statistics.shadow_rays += before.shadow_rays;
  statistics.layer_rays += before.layer_rays;
  statistics.nodes += before.nodes;
  statistics.filtered_nodes += before.filtered_nodes;
  statistics.differential_nodes += before.differential_nodes;
  statistics.textured_nodes += before.textured_nodes;
  statistics.picture_seconds += before.picture_seconds;
  statistics.shade_thread_seconds += before.shade_thread_seconds;
  for (std::size_t i = 0; i < scene::kPartCount; ++i) {
    scene::Cost& cost = ledger.costs[i];
    cost.calls += picture.ledger.costs[i].calls;
    cost.bytes = std::max(cost.bytes, picture.ledger.costs[i].bytes);
  }
  ++pictures;
  if (!picture.error) return;
  const double squares =
      static_cast<double>(estimates) * error.rmse * error.rmse + picture.error->rmse * picture.error->rmse;
  ++estimates;
  error.rmse = std::sqrt(squares / static_cast<double>(estimates));
  error.checked_pixels += picture.error->checked_pixels;
  error.checking_rays += picture.error->checking_rays;
  error.seconds += picture.error->seconds;
}

Report statistics_report(const RenderTotal& total, const Phases& phases, const scene::Plan& plan,
                         double run_seconds) {
  const render::Statistics& statistics = total.statistics;
  return {{{"pictures", total.pictures},
           {"eye_rays", statistics.eye_rays},
           {"refined_pixels", statistics.refined_pixels},
           {"refining_rays", statistics.refining_rays},
           {"reflected_rays", statistics.reflected_rays},
           {"refracted_rays", statistics.refracted_rays},
           {"shadow_rays", statistics.shadow_rays},
           {"layer_rays", statistics.layer_rays},
           {"nodes", statistics.nodes},
           {"textured_nodes", statistics.textured_nodes},
           {"filtered_nodes", statistics.filtered_nodes},
           {"differential_nodes", statistics.differential_nodes},
           {"build_seconds", statistics.build_seconds},
           {"picture_seconds", statistics.picture_seconds},
           {"shade_thread_seconds", statistics.shade_thread_seconds},
           {"peak_bytes", peak_memory()},
           {"accelerator_bytes", statistics.accelerator_bytes},
           {"voxels", statistics.voxels},
           {"median_triangles", std::uint64_t{statistics.median_triangles}},
           {"p99_triangles", std::uint64_t{statistics.p99_triangles}},
           {"max_triangles", std::uint64_t{statistics.max_triangles}},
           {"checked_pixels", total.error.checked_pixels},
           {"checking_rays", total.error.checking_rays},
           {"check_seconds", total.error.seconds},
           {"error_estimate", total.estimates > 0 ? Value(total.error.rmse) : Value()},
           {"run_seconds", run_seconds}},
          {phases.table(), plan_table(plan, total.ledger)}};
}

}  // namespace sweepkit::tools
