// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "section.hpp"

namespace sweepkit::sweep {

/// Sections and a number of cells round the turn, within a tolerance of the surface turned.
struct TurnedGrid {
  std::vector<Section> sections;  ///< an outline
  int columns = 0;
  double deviation = 0;  ///< measured
};

/// The grid of fewest triangles, nearly. `dense`: sections as sample_densely() makes them, points on the axis
/// exactly there. Throws InputError where it would take too many cells.
TurnedGrid fit_turned_grid(const std::vector<Section>& dense, double angle_deg, double tolerance);

}  // namespace sweepkit::sweep
