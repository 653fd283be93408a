// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "object_reader.hpp"
#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

std::vector<ObjectEntry> read_objects(const Node& node, const std::vector<Material>& materials);

}  // namespace sweepkit::scene
