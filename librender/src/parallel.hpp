// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <optional>

namespace sweepkit::render {

/// body(range) for parts of 0..count-1, `grain` long or about so, on so many threads; 0: all of the machine.
template <typename Body>
void parallel_ranges(int threads, std::size_t count, std::size_t grain, const Body& body) {
  // More threads than the machine has must be allowed first, or TBB prints a warning and takes fewer.
  std::optional<tbb::global_control> allowed;
  if (threads > 0)
    allowed.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), body); });
}

}  // namespace sweepkit::render
