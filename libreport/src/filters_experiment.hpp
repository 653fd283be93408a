// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sweepkit/report/experiment.hpp"
#include "texture_peer.hpp"

namespace sweepkit::report {

/// Texture filters on a plane that runs to the horizon, and OpenImageIO's texture system beside them.
Experiment measure_filters(const Effort& effort);

/// The same beside this peer, or, where it is nullptr, without one for this reason. Throws
/// OutputError where the peer cannot write its pyramid into TMPDIR.
Experiment measure_filters_beside(const Effort& effort, const TexturePeer* peer, const std::string& reason);

}  // namespace sweepkit::report
