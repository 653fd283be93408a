// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

/// Of the outlines that bound a region: for each the outer outline of its piece, itself if it is that one.
/// An outline inside of an odd number of others is a hole. What crosses is not inside.
/// Throws InputError without an outline, and where one of several is open.
std::vector<std::size_t> nest_outlines(std::span<const Curve2> outlines);

}  // namespace sweepkit::sweep
