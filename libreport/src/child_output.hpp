// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sweepkit::report {

/// Runs a program to its end and gives what it wrote to standard output; nothing where it cannot be started
/// or ends with another status than 0.
std::optional<std::string> child_output(const std::filesystem::path& program,
                                        const std::vector<std::string>& arguments);

}  // namespace sweepkit::report
