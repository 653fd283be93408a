// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/gltf.hpp"

namespace sweepkit::scene {

/// A glTF's buffer is smaller than this: a .glb over 4 GiB wraps its length round without a word, and 2 GiB
/// is what readers can be trusted with.
inline constexpr std::uint64_t kMostGltfBytes = std::uint64_t{1} << 31;

/// Before meshes are made: refuses an object that would be too large for a glTF file by its numbers of cells,
/// and has shapes that a tolerance divides refused as soon as they are (Tessellation::most_triangles). Only
/// what is sure to be too large, each object by itself, since equal ones share their arrays; make_gltf()
/// finds the rest. Throws InputError with the place of the object's first piece.
void check_gltf_size(Document& document, const GltfOptions& options);

}  // namespace sweepkit::scene
