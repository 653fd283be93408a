// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "phases.hpp"
#include "report.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/plan.hpp"

namespace sweepkit::tools {

/// What all pictures of a run cost together.
struct RenderTotal {
  std::uint64_t pictures = 0;
  render::Statistics statistics;
  scene::Ledger ledger;
  std::uint64_t estimates = 0;  ///< of the pictures, those with one
  render::ErrorEstimate error;  ///< the root of their mean squared error, and all their checks

  /// Counts and times are added up; what is held from one picture to the next is counted once.
  void add(const render::Picture& picture);
};

/// --stats, `run_seconds` after the program's start; docs/rendering.md tells what every key means.
Report statistics_report(const RenderTotal& total, const Phases& phases, const scene::Plan& plan,
                         double run_seconds);

}  // namespace sweepkit::tools
