// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/scene/model.hpp"

namespace sweepkit::scene {

/// Makes an object's mesh, with tangents and half-edges where the plan needs them, and appends it and its
/// view; what it cost is in the model's ledger. Throws InputError with the place of the piece at fault.
void add_mesh_of(const ObjectEntry& object, const Document& document, const Plan& plan, Model& model);

}  // namespace sweepkit::scene
