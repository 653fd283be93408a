// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "temporary_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "sweepkit/error.hpp"

namespace sweepkit::texmap {

TemporaryFile::TemporaryFile(std::string content) : content_(std::move(content)) {
  std::string name = (std::filesystem::temp_directory_path() / "sweepkit-XXXXXX").string();
  file_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (file_ < 0) fail_to_write();
  ::unlink(name.c_str());
}

TemporaryFile::~TemporaryFile() {
  ::close(file_);
}

void TemporaryFile::append(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail_to_write();
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void TemporaryFile::read(std::int64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(file_, bytes.data(), bytes.size(), offset);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw OutputError("the temporary file of " + content_ + " cannot be read");
    offset += got;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
}

void TemporaryFile::fail_to_write() const {
  const std::string why = std::strerror(errno);
  throw OutputError("cannot unpack " + content_ + " into a temporary file in " +
                    std::filesystem::temp_directory_path().string() + ": " + why +
                    "; make room, set TMPDIR to another folder, or give more --texture-memory");
}

}  // namespace sweepkit::texmap
