// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/scene/document.hpp"
#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::scene {

sweep::SweepOptions sweep_options(const Piece& piece, const SweepShape& shape);
sweep::RevolveOptions revolve_options(const Piece& piece, const RevolveShape& shape);

/// A piece's mesh in its own space. Throws InputError as libsweep does.
sweep::Mesh make_mesh(const Piece& piece, bool has_half_edges);

}  // namespace sweepkit::scene
