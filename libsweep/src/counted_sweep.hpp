// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "morph.hpp"
#include "outline_sampler.hpp"
#include "spine.hpp"
#include "stations.hpp"
#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// A sweep divided by counts: columns by outline, rows by the trajectory's stations.
struct CountedSweep {
  std::vector<Morph> morphs;
  Spine spine;
};

/// `cells` columns in all, shared by length; more only where a closed trajectory comes home turned by a part
/// of the contour's symmetry by which so many columns do not repeat: 64 cells on a star of 5 points become
/// 70. The trajectory's corners are joined. Throws InputError as its parts do.
CountedSweep make_counted_sweep(const ContourSamplers& samplers, int cells, const Curve3& trajectory,
                                const std::vector<Station>& stations, const SweepOptions& options);

}  // namespace sweepkit::sweep
