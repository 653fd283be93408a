// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace sweepkit::sweep {

/// The distance of a point from a segment, and from a triangle of any shape, one without area too.
double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b);
double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                            const glm::dvec3& c);

}  // namespace sweepkit::sweep
