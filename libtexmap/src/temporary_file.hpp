// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace sweepkit::texmap {

/// A file without a name, in the folder that TMPDIR names: what does not fit in memory. It goes with the
/// program, however that ends. One thread writes; any number read what was written.
class TemporaryFile {
 public:
  /// `content` names what is put there, in errors. Throws OutputError if there can be no such file.
  explicit TemporaryFile(std::string content);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// Throws OutputError when the disk is full.
  void append(std::span<const std::byte> bytes);
  /// Fills `bytes` from `offset` on. Throws OutputError if it cannot be read.
  void read(std::int64_t offset, std::span<std::byte> bytes) const;

 private:
  [[noreturn]] void fail_to_write() const;

  std::string content_;
  int file_ = -1;
};

}  // namespace sweepkit::texmap
