// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>

namespace sweepkit::sweep {

/// Sides `first` and `second` of a polygon, which begin at the points of those numbers, cross at `point`.
struct OutlineCrossing {
  std::size_t first, second;
  glm::dvec2 point;
};

/// A place where a polygon goes through itself, if there is one. Sides that touch, and neighbours, do not.
std::optional<OutlineCrossing> find_crossing(std::span<const glm::dvec2> points, bool is_closed);

}  // namespace sweepkit::sweep
