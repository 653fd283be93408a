// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "make_mesh.hpp"

namespace sweepkit::scene {

/// The mesh of a mesh file: its (u,v) times the piece's repeat, or laid out over the unit square by right
/// triangles where it has none and they are needed, the right angle in the middle; its normals, or found
/// ones. Throws InputError with the piece's place, the file's own in the text.
sweep::Mesh make_mesh_shape(const Piece& piece, const MeshShape& shape, const MeshNeeds& needs,
                            Cost& layout_cost);

}  // namespace sweepkit::scene
