// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "expected_counts.hpp"

#include <algorithm>

namespace sweepkit::scene {
namespace {

std::uint64_t cells_along(std::span<const sweep::Curve2> contour, int wanted) {
  std::uint64_t corners = 0;
  for (const sweep::Curve2& outline : contour) corners += outline.is_closed() ? 3 : 1;
  return std::max<std::uint64_t>(corners, static_cast<std::uint64_t>(wanted));
}

ExpectedCounts grid(std::uint64_t columns, std::uint64_t rows) {
  return {(columns + 1) * (rows + 1), 2 * columns * rows};
}

}  // namespace

ExpectedCounts expected_counts(const Piece& piece) {
  if (std::holds_alternative<MeshShape>(piece.shape) || piece.tessellation.tolerance) return {};
  const auto along = static_cast<std::uint64_t>(piece.tessellation.trajectory);
  if (const auto* swept = std::get_if<SweepShape>(&piece.shape))
    return grid(cells_along(swept->contour, piece.tessellation.contour), along);
  if (const auto* revolved = std::get_if<RevolveShape>(&piece.shape))
    return grid(cells_along(revolved->contour, piece.tessellation.contour), along);
  return grid(static_cast<std::uint64_t>(piece.tessellation.contour), along);
}

}  // namespace sweepkit::scene
