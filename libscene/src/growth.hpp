// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

/// How a swept mesh grows from its start to its end, time 0 to 1 going by v along a trajectory and by u round
/// a turn. At states[k] what is not there yet lies on the growing end, flat, where no picture shows it; in
/// between everything goes straight from state to state, and after the last one comes the whole mesh.
struct Growth {
  struct State {
    double time = 0;
    std::vector<glm::vec3> moved;   ///< position in this state - position in the mesh, a vertex each
    std::vector<glm::vec3> turned;  ///< the same of normals
  };
  std::vector<State> states;
  double error = 0;  ///< metres that a vertex of the growing end is from its place, at most
};

inline constexpr std::size_t kMostGrowthStates = 64;

/// The fewest states, set one after the other as far apart as they can be, by which the middle of the growing
/// end keeps within 2 % of the mesh's diagonal of its way, and its points within 10 % of the section's
/// largest radius of their places about the middle. Twice as much and so on where kMostGrowthStates would not
/// do. All swept parts grow at once and others stand still; none: no part is swept.
std::optional<Growth> grow(const MeshView& mesh);

}  // namespace sweepkit::scene
