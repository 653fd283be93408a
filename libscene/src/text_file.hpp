// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "sweepkit/error.hpp"

namespace sweepkit::scene {

/// A file's bytes. Throws InputError naming the file where it is missing, a folder, unreadable or larger than
/// `most` bytes (whole MiB); `kind` says what was meant ("a scene file").
std::string read_text_file(const std::filesystem::path& file, std::size_t most, const std::string& kind);

/// Line and column of the byte at `offset`. One call walks the text before it: for messages.
Place place_in(std::string_view text, std::size_t offset, const std::string& file);

}  // namespace sweepkit::scene
