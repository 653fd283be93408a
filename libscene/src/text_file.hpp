// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace sweepkit::scene {

/// The whole text of a file, at most 256 MiB. `kind` names what it should be in messages: "a scene file".
/// Throws InputError naming the file: missing, a folder, unreadable, too large.
std::string read_text_file(const std::filesystem::path& file, const std::string& kind);

}  // namespace sweepkit::scene
