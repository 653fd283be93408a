// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>

#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

// What a write in progress has on the disk, where a signal handler can read it: fixed storage, published by a
// count.
constexpr std::size_t kMostFiles = 64;
constexpr std::size_t kLongestPath = 4096;
std::array<std::array<char, kLongestPath>, kMostFiles> pending;
std::atomic<std::size_t> pending_count = 0;

bool is_standard_output(const std::filesystem::path& file) {
  return file == "-";
}

std::string reason() {
  return std::strerror(errno);
}

void write_all(int descriptor, std::span<const std::byte> bytes, const std::string& name) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t count = ::write(descriptor, bytes.data() + written, bytes.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw OutputError(name + ": cannot be written: " + reason());
    written += static_cast<std::size_t>(count);
  }
}

// A device or pipe cannot be replaced by renaming; it is written to as it is.
bool is_written_in_place(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

void write_in_place(const OutputFile& file) {
  const bool is_standard = is_standard_output(file.path);
  const int descriptor = is_standard ? STDOUT_FILENO : ::open(file.path.c_str(), O_WRONLY | O_CLOEXEC);
  const std::string name = is_standard ? "standard output" : file.path.string();
  if (descriptor < 0) throw OutputError(name + ": cannot be written: " + reason());
  try {
    write_all(descriptor, file.bytes, name);
  } catch (...) {
    if (!is_standard) ::close(descriptor);
    throw;
  }
  if (!is_standard && ::close(descriptor) != 0) throw OutputError(name + ": cannot be written: " + reason());
}

// The file that a link leads to is replaced, not the link.
std::filesystem::path real_target(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::path target = std::filesystem::weakly_canonical(file, ignored);
  return ignored || target.empty() ? file : target;
}

// Writes beside `target` and returns the temporary's name, registered as pending.
std::string write_beside(const std::filesystem::path& target, std::span<const std::byte> bytes) {
  std::string name = target.parent_path() / ".";
  name.append(target.filename()).append(".XXXXXX");
  const std::size_t slot = pending_count;
  if (slot >= kMostFiles || name.size() >= kLongestPath)
    throw OutputError(target.string() + ": too many files or too long a name");
  const int descriptor = ::mkstemp(name.data());
  if (descriptor < 0) throw OutputError(target.string() + ": cannot be written: " + reason());
  std::memcpy(pending[slot].data(), name.c_str(), name.size() + 1);
  pending_count = slot + 1;
  try {
    write_all(descriptor, bytes, target.string());
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  // mkstemp makes files for their owner alone; an output is as readable as any other new file.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor, 0666 & ~mask);
  if (::close(descriptor) != 0) throw OutputError(target.string() + ": cannot be written: " + reason());
  return name;
}

}  // namespace

void check_output(const std::filesystem::path& file) {
  if (is_standard_output(file)) return;
  std::error_code ignored;
  if (file.empty() || file.filename().empty())
    throw InputError({.file = file.string()}, "names no file to write");
  if (std::filesystem::is_directory(file, ignored))
    throw InputError({.file = file.string()}, "is a folder; name a file in it");
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, ignored)) {
    throw InputError({.file = file.string()}, "there is no folder " + folder.string() + "; make it first");
  }
  const bool is_writable = is_written_in_place(file) ? ::access(file.c_str(), W_OK) == 0
                                                     : ::access(folder.c_str(), W_OK | X_OK) == 0;
  if (!is_writable) throw InputError({.file = file.string()}, "cannot be written: " + reason());
}

void write_files(std::span<const OutputFile> files) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  std::vector<std::pair<std::string, std::filesystem::path>> renames;
  try {
    for (const OutputFile& file : files) {
      if (is_standard_output(file.path) || is_written_in_place(file.path)) continue;
      const std::filesystem::path target = real_target(file.path);
      renames.emplace_back(write_beside(target, file.bytes), target);
    }
    for (const OutputFile& file : files) {
      if (is_standard_output(file.path) || is_written_in_place(file.path)) write_in_place(file);
    }
    for (const auto& [temporary, target] : renames) {
      if (std::rename(temporary.c_str(), target.c_str()) != 0) {
        throw OutputError(target.string() + ": cannot be written: " + reason());
      }
    }
  } catch (...) {
    abandon_writes();
    throw;
  }
  pending_count = 0;
}

void abandon_writes() noexcept {
  const std::size_t count = pending_count.exchange(0);
  for (std::size_t i = 0; i < count; ++i) ::unlink(pending[i].data());
}

}  // namespace sweepkit::scene
