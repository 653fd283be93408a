// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

namespace sweepkit::tools {

/// Lets the program have as much memory as the machine has, and no more: work that is too large then ends
/// with a message instead of being killed half way, or taking the machine down with it.
void limit_memory();

}  // namespace sweepkit::tools
