// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Which turn a closed trajectory comes home by is a matter of the contour and not of its columns: a star with
// a twist of a fifth of a turn stays twisted by however many cells it is drawn. But the last row's columns
// have to lie on the first one's, turned so.

#include "counted_sweep.hpp"

#include <algorithm>
#include <numeric>

namespace sweepkit::sweep {
namespace {

// The contour's symmetry, at most kMostPeriods.
int periods_of(const ContourSamplers& samplers) {
  int periods = 0;
  for (OutlineSampler outline : samplers.outlines) {
    outline.make_periodic(kMostPeriods);
    periods = std::gcd(periods, outline.periods());
  }
  return periods;
}

// A circle's columns: every one of them is a step of the symmetry, and more cannot be had.
bool repeats_by_every_column(const CountedSweep& sweep) {
  return std::all_of(sweep.morphs.begin(), sweep.morphs.end(), [&](const Morph& morph) {
    return morph.columns() == static_cast<std::size_t>(sweep.spine.symmetry);
  });
}

// The share of a whole turn by which a loop comes home, as a fraction of whole numbers.
bool come_home_alike(const Spine& a, const Spine& b) {
  return a.closing_steps * b.symmetry == b.closing_steps * a.symmetry;
}

}  // namespace

CountedSweep make_counted_sweep(const ContourSamplers& samplers, int cells, const Curve3& trajectory,
                                const std::vector<Station>& stations, const SweepOptions& options) {
  CountedSweep given{sample(samplers, cells), {}};
  given.spine = make_spine(trajectory, stations, given.morphs, options);
  if (!given.spine.is_closed || repeats_by_every_column(given) ||
      given.spine.symmetry >= periods_of(samplers)) {
    return given;
  }
  CountedSweep repeating{sample_periodically(samplers, cells), {}};
  repeating.spine = make_spine(trajectory, stations, repeating.morphs, options);
  return come_home_alike(given.spine, repeating.spine) ? given : repeating;
}

}  // namespace sweepkit::sweep
