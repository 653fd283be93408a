// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
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
  std::vector<std::span<const std::byte>> more = {};  ///< what follows them
};

/// Writes the files whole or not at all: each beside its place under another name, checked to the disk, then
/// renamed, in the order given (so the file that names the others goes last). "-" goes to standard output.
/// Any number of threads may write at once. Throws OutputError (disk full, ...) and leaves nothing behind.
void write_files(std::span<const OutputFile> files);

/// The same in two steps, for work that goes on between them.
class StagedFiles {
 public:
  StagedFiles();
  ~StagedFiles();  ///< removes what was not put in its place
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  /// Writes the file beside its place; to standard output, a pipe or a device not before put_in_place(), so
  /// that its bytes must last till then.
  void add(const OutputFile& file);
  void put_in_place();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Removes what writes in progress, on any thread, have on the disk, and lets none of them go on. For the
/// handler of Ctrl-C, which then ends the process: async-signal-safe.
void abandon_writes() noexcept;

}  // namespace sweepkit::scene
