// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "object_reader.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::scene {

/// CURVE of the scene format as a contour: one outline, or several that bound one region; never empty.
/// `folder` is what file names are relative to.
std::vector<sweep::Curve2> read_contour(const Node& node, const std::filesystem::path& folder);

/// CURVE as a trajectory.
sweep::Curve3 read_trajectory(const Node& node, const std::filesystem::path& folder);

}  // namespace sweepkit::scene
