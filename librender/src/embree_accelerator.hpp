// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "mesh_accelerator.hpp"

namespace sweepkit::render {

/// Embree's tree over the mesh's triangles. Which triangle is met Embree says, in float32; t and (a, b, c)
/// are ShearedRay's. So its hits are those of the others but at edges and silhouettes, where float32 may
/// choose the neighbour, or at a vertex slip through: Embree's robust mode misses about 2 % of the rays that
/// are aimed exactly at one. Throws std::bad_alloc where Embree finds no memory, and InputError in a build
/// without it.
std::unique_ptr<const MeshAccelerator> make_embree_accelerator(const scene::MeshView& mesh);

}  // namespace sweepkit::render
