// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace sweepkit::scene {

/// The JSON Schema (draft 2020-12) of scene files, version 1, for editors and scripts. What it refuses
/// SceneFile::document() refuses too; it cannot see what goes across values (names that are not there, curves
/// that cross themselves) or lies in other files.
std::string_view scene_schema();

}  // namespace sweepkit::scene
