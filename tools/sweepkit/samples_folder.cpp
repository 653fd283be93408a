// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "samples_folder.hpp"

namespace sweepkit::tools {

std::filesystem::path samples_folder() {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::canonical("/proc/self/exe", ignored).parent_path();
  // In a build tree a link to the source tree's, which CMake makes.
  for (const std::filesystem::path& place : {folder / "samples", folder / "../share/sweepkit/samples"}) {
    if (std::filesystem::is_directory(place / "scenes", ignored)) {
      return std::filesystem::canonical(place, ignored);
    }
  }
  return {};
}

}  // namespace sweepkit::tools
