// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "intersection_tree.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::render {

/// Do two trees show different things? They do where one has a node that the other has not, or where two on
/// the same path lie on different pieces, on surfaces at more than 26 degrees to each other, or have more
/// than `least` between what they see of a light. Nodes whose whole share of the pixel is `least` or below
/// are passed over.
bool differ(const scene::Scene& scene, const TreeRow& row_a, std::size_t a, const TreeRow& row_b,
            std::size_t b, double least);

}  // namespace sweepkit::render
