// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

struct ExpectedCounts {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
};

/// Of the mesh that a piece divided by counts will have, within 5 %; 0 for one by tolerance and a mesh file.
ExpectedCounts expected_counts(const Piece& piece);

}  // namespace sweepkit::scene
