// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::scene {

sweep::SweepOptions sweep_options(const Piece& piece, const SweepShape& shape);
sweep::RevolveOptions revolve_options(const Piece& piece, const RevolveShape& shape);

/// What is made of a mesh besides its triangles.
struct MeshNeeds {
  bool half_edges = false;
  bool layout = false;  ///< (u,v) for mesh files that have none; else they are 0
};

/// A piece's mesh in its own space; a layout's cost is added. Throws InputError as libsweep and
/// read_mesh_file() do, with the piece's place for a mesh file.
sweep::Mesh make_mesh(const Piece& piece, const MeshNeeds& needs, Cost& layout_cost);

}  // namespace sweepkit::scene
