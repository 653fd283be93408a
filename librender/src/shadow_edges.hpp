// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "neighbourhood.hpp"

namespace sweepkit::render {

/// What of a light comes to the node nodes[1][1], by colour: traced for its own point alone.
/// Precondition: the node is not turned away from the light.
glm::dvec3 own_share(const RowWindow& rows, const Neighbourhood& nodes, std::size_t light);

/// The same, averaged over the nodes of the same path in the 3 x 3 pixels about it that lie on the same piece
/// of surface and are not turned away from the light either. Where all of them say the same it is that, to
/// the bit.
glm::dvec3 smooth_share(const RowWindow& rows, const Neighbourhood& nodes, std::size_t light);

}  // namespace sweepkit::render
