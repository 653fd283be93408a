// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "object_reader.hpp"
#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

/// "translate", "rotate_deg" and "scale" of an object, a part or an instance. Throws InputError with place.
Placement read_placement(ObjectReader& reader);

/// "instances": a list of placements, at least one; none where the key is missing.
std::vector<Placement> read_instances(ObjectReader& reader);

}  // namespace sweepkit::scene
