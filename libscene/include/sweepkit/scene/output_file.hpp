// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace sweepkit::scene {

/// Refuses an output that cannot be written, before any work: a folder that is not there or not writable, a
/// folder where the file should be. "-" is standard output. Throws InputError.
void check_output(const std::filesystem::path& file);

struct OutputFile {
  std::filesystem::path path;
  std::span<const std::byte> bytes;
};

/// Writes the files whole or not at all: each beside its place under another name, checked to the disk, then
/// renamed, in the order given (so the file that names the others goes last). "-" goes to standard output.
/// Any number of threads may write at once. Throws OutputError (disk full, ...) and leaves nothing behind.
void write_files(std::span<const OutputFile> files);

/// Removes what writes in progress, on any thread, have on the disk, and lets none of them go on. For the
/// handler of Ctrl-C, which then ends the process: async-signal-safe.
void abandon_writes() noexcept;

}  // namespace sweepkit::scene
