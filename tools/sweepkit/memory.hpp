// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "sweepkit/scene/memory_estimate.hpp"

namespace sweepkit::tools {

/// Lets the program have as much memory as the machine has, and no more: work that is too large then ends
/// with a message instead of being killed half way, or taking the machine down with it.
void limit_memory();

/// What the program may still take.
struct MemoryLeft {
  std::uint64_t bytes = 0;
  std::string bound;  ///< who says so: "ulimit -v", "this machine", ...
};
/// The least of what the machine has free and what the limits of the process and of its control groups leave.
MemoryLeft memory_left();

/// Throws InputError for the scene `name` if it needs more than is left: how much, for what, how much there
/// is and what to do. `more` bytes come on top of what the scene itself takes.
void require_memory(const std::string& name, const scene::MemoryEstimate& estimate, std::uint64_t more);

/// Lets every shape that a tolerance divides have as many triangles as what is left has room for, at that
/// many bytes each besides the mesh's own.
void limit_triangles(scene::Document& document, std::uint64_t more_a_triangle);

}  // namespace sweepkit::tools
