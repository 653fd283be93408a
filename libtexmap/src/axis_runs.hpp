// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "pyramid.hpp"
#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::texmap {

/// Texels first, first + 1, ... first + count - 1 of an axis that goes on for ever under a wrap, where they
/// lie in one tile: texel first + k at `offset` + k * step of it.
struct AxisRun {
  int first;
  int count;
  int tile;
  int offset;
  int step;  ///< 1; -1 where the image is mirrored; 0 past the edge of one that is clamped
};

/// A texel of 0..size-1, and whether the texels after it come in falling order.
struct WrappedTexel {
  int texel;
  bool is_mirrored = false;
};
inline WrappedTexel wrapped(int index, int size, Wrap wrap) {
  if (index >= 0 && index < size) return {index};
  if (wrap == Wrap::kClamp) return {std::clamp(index, 0, size - 1)};
  const int period = wrap == Wrap::kMirror ? 2 * size : size;
  const int inside = ((index % period) + period) % period;
  return inside < size ? WrappedTexel{inside} : WrappedTexel{period - 1 - inside, true};
}

/// Cuts the texels first..last at the image's edges and at its tiles' into `runs`, in order.
inline void cut_into_runs(int first, int last, int size, Wrap wrap, std::vector<AxisRun>& runs) {
  runs.clear();
  while (first <= last) {
    const auto [texel, is_mirrored] = wrapped(first, size, wrap);
    const int offset = texel % kTileSide;
    int step = 1;
    int count = last - first + 1;
    if (wrap == Wrap::kClamp && (first < 0 || first >= size)) {
      step = 0;
      if (first < 0) count = std::min(count, -first);
    } else if (is_mirrored) {
      step = -1;
      count = std::min(count, offset + 1);
    } else {
      count = std::min({count, size - texel, kTileSide - offset});
    }
    runs.push_back({first, count, texel / kTileSide, offset, step});
    first += count;
  }
}

}  // namespace sweepkit::texmap
