// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

namespace sweepkit::tools {

/// Ctrl-C, a closed pipe or terminal and a polite kill remove what a write has begun and end the program with
/// 128 plus the signal's number (130 for Ctrl-C). A signal that the caller had set to be ignored stays so. A
/// file beyond the limit of `ulimit -f` ends nothing by itself: the write fails.
void handle_interrupts();

}  // namespace sweepkit::tools
