// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "object_reader.hpp"
#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

/// `folder` is what the names of curve files are relative to.
std::vector<ObjectEntry> read_objects(const Node& node, const std::vector<Material>& materials,
                                      const std::filesystem::path& folder);

}  // namespace sweepkit::scene
