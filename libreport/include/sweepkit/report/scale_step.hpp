// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace sweepkit::report {

/// A piece of work that a process of its own does, so that its memory can be told.
struct ScaleStep {
  std::string work;  ///< "generate" meshes, "render" a picture (or "render 3x3"), "export" a .glb in memory
  std::filesystem::path scene;
  int threads = 1;  ///< for rendering
  int side = 64;    ///< of the picture, pixels
};

/// Does it and tells "MEDIAN LEAST MOST RUNS BYTES": seconds, and the peak of the resident memory above what
/// the process held before the work ("nan" where the system does not tell). Throws InputError for other work
/// and as the scene's reading does.
std::string run_scale_step(const ScaleStep& step);

}  // namespace sweepkit::report
