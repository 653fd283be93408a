// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "object_reader.hpp"
#include "sweepkit/sweep/law.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::scene {

/// LAW of the scene format: a number, {"points": [[t, value], ...]} or {"bezier": [[t, value], ...]}, its
/// values in `range`.
sweep::Law read_law(const Node& node, const Range& range);

/// LAW for both axes, or {"x": LAW, "y": LAW}.
sweep::Profile read_profile(const Node& node);

/// TWIST: a number is the total turn, a law the angle at t.
sweep::Law read_twist(const Node& node);

}  // namespace sweepkit::scene
