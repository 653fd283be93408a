// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

/// How far on average a straight line goes inside a closed mesh before it comes out, metres in the mesh's own
/// space: 4 V / S (Cauchy), of lines of every place and direction. A ball of radius r has 4 r / 3, a long rod
/// and a thin ring of it 2 r, a long pipe and a large pane twice the thickness of the wall. V and S are those
/// of the triangles. None where the mesh is not closed: vertices in one place are one, and each edge must be
/// gone along as often one way as the other. None either where it has no volume.
std::optional<double> mean_chord(const MeshView& mesh);

/// Bytes that it takes for a while.
std::size_t mean_chord_bytes(const MeshView& mesh);

}  // namespace sweepkit::scene
