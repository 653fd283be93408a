// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

/// What a triangle of a large mesh takes with its share of the vertices, half a one.
inline constexpr std::uint64_t kLeastBytesATriangle = 30;

/// What a document's meshes and objects will be like, before a byte of them is taken.
struct MemoryEstimate {
  std::uint64_t triangles = 0;  ///< of all meshes, an instanced one once
  std::uint64_t objects = 0;    ///< an instance is one
  std::uint64_t bytes = 0;      ///< of the Model that build() makes
};

/// From the numbers of cells, and for mesh files from the files' sizes: within a few percent for what is
/// swept and revolved, roughly for mesh files. Shapes that a tolerance divides count nothing: how many cells
/// they need is found by dividing them, and Tessellation::most_triangles stops that. Throws InputError with
/// the place of a shape that has too many triangles for any memory.
MemoryEstimate estimate_memory(const Document& document);

}  // namespace sweepkit::scene
