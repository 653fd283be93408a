// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "spine.hpp"

#include <algorithm>
#include <numeric>

#include "orientation.hpp"
#include "section.hpp"
#include "sweepkit/error.hpp"
#include "symmetry.hpp"

namespace sweepkit::sweep {
namespace {

std::vector<bool> row_breaks(const std::vector<Row>& rows, const SweepOptions& options) {
  // At 180 degrees nothing breaks.
  const double crease_cos = crease_cosine(options.joints == Joints::kSmooth ? 180 : options.crease_deg);
  std::vector<bool> breaks;
  breaks.reserve(rows.size());
  for (const Row& row : rows) {
    breaks.push_back(row.is_pole || row.is_pressed ||
                     (row.is_corner && glm::dot(row.in.frame.tangent, row.out.frame.tangent) < crease_cos));
  }
  return breaks;
}

// Turned by a whole turn / this, every outline covers itself.
int symmetry_of(const std::vector<Morph>& morphs) {
  int symmetry = 0;
  for (const Morph& morph : morphs) {
    // What changes on the way is not looked into.
    symmetry = std::gcd(symmetry, morph.changes() ? 1 : symmetry_of(morph.keys.front()));
  }
  return symmetry;
}

void check_morphs_close(const std::vector<Morph>& morphs) {
  for (const Morph& morph : morphs) {
    if (!morph.changes()) continue;
    const Section last = section_at(morph, 1);
    const Section& first = morph.keys.front();
    for (std::size_t i = 0; i < first.points.size(); ++i) {
      // A millionth is what float32 would not show.
      if (glm::length(last.points[i].position - first.points[i].position) > 1e-6 * reach_of(first)) {
        throw InputError(
            "morph ends in another contour than it began with, but the trajectory is closed; end it with the "
            "contour itself at t = 1");
      }
    }
  }
}

}  // namespace

Spine make_spine(const Curve3& trajectory, const std::vector<Station>& stations,
                 const std::vector<Morph>& morphs, const SweepOptions& options, int most_symmetry) {
  Spine spine;
  spine.length = trajectory.length();
  spine.is_closed = trajectory.is_closed();
  if (spine.is_closed) {
    check_loop(stations.size() - 1, "trajectory");
    check_morphs_close(morphs);
    const int symmetry = symmetry_of(morphs);
    spine.symmetry = std::min(symmetry, most_symmetry);
    while (symmetry % spine.symmetry != 0) --spine.symmetry;
  }
  const Oriented oriented =
      orient(trajectory, stations, options.orientation, options.twist_deg, spine.symmetry);
  spine.closing_steps = oriented.closing_steps;
  spine.rows = make_rows(trajectory, stations, oriented.frames, options.profile);
  spine.breaks = row_breaks(spine.rows, options);
  spine.poles.resize(spine.rows.size());
  std::transform(spine.rows.begin(), spine.rows.end(), spine.poles.begin(),
                 [](const Row& row) { return row.is_pole; });
  spine.shares = texture_fractions(stations, UvBy::kArcLength);
  spine.v = texture_fractions(stations, options.uv.by);
  spine.runs = split_runs(spine.breaks);
  return spine;
}

std::size_t closing_columns(const Morph& morph, const Spine& spine, bool is_hole) {
  const auto columns = static_cast<int>(morph.columns());
  // A hole's columns run the other way round.
  const int steps = is_hole ? -spine.closing_steps : spine.closing_steps;
  const int turns = (steps % spine.symmetry + spine.symmetry) % spine.symmetry;
  return static_cast<std::size_t>(columns / spine.symmetry) * static_cast<std::size_t>(turns);
}

}  // namespace sweepkit::sweep
