// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace sweepkit::tools {

/// The sample scenes that come with the program: beside it in a build tree, in share/sweepkit/samples where
/// it is installed. Empty where there are none.
std::filesystem::path samples_folder();

}  // namespace sweepkit::tools
