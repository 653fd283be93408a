// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

/// A curve that an object was made of, where it lies in the world: points of it, metres, near enough to each
/// other to be joined by straight lines on a screen. A closed one ends where it begins.
struct DrawnCurve {
  enum class Kind {
    kTrajectory,
    kContour,  ///< of a sweep: as it stands at the trajectory's start; of a revolve: where the turn begins
    kAxis,     ///< of a revolve, as high as its contour
  };
  Kind kind;
  std::vector<glm::dvec3> points;
};

/// Of all pieces, in their order, once for each instance. Planes and mesh files have none. Throws InputError
/// as libsweep does for a shape that cannot be made.
std::vector<DrawnCurve> drawn_curves(const ObjectEntry& object);

}  // namespace sweepkit::scene
