// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace sweepkit::sweep {

/// How far a line is from straight: `error(a, b)` is the largest distance of its places between a and b from
/// the chord between them; it grows with either end.
using ChordError = std::function<double(std::size_t a, std::size_t b)>;

/// Places first = c[0] < c[1] < ... = last, as few as keep every chord's error within `bound` (greedily,
/// which is the fewest there can be). Chords between neighbours are taken whatever their error. Asks for at
/// least `least` cells as far as there are places.
std::vector<std::size_t> cut(std::size_t first, std::size_t last, std::size_t least, const ChordError& error,
                             double bound);

}  // namespace sweepkit::sweep
