// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Files are written under another name in their own folder, so that the rename at the end stays on one disk
// and is one step. What is on the disk meanwhile is listed where a signal handler can read it.

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

constexpr std::size_t kLongestPath = 4096;

// One name on the disk. Entries are never given back, only used again: a handler may be reading the list at
// any moment.
struct Pending {
  std::array<char, kLongestPath> path;
  std::atomic<bool> is_live = false;
  Pending* next = nullptr;
};
std::atomic<Pending*> pending = nullptr;

Pending& free_entry() {
  for (Pending* entry = pending; entry != nullptr; entry = entry->next) {
    if (!entry->is_live) return *entry;
  }
  auto* entry = new Pending;
  entry->next = pending;
  pending = entry;
  return *entry;
}

bool is_standard_output(const std::filesystem::path& file) {
  return file == "-";
}

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw OutputError(file.string() + ": cannot be written: " + std::strerror(errno));
}

class Descriptor {
 public:
  Descriptor(int number, std::filesystem::path name) : number_(number), name_(std::move(name)) {
    if (number_ < 0) fail(name_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  void write(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::write(number_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) fail(name_);
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }
  void set_mode(mode_t mode) const { ::fchmod(number_, mode); }
  // Some disks tell only now that they are full.
  void close() {
    const int number = std::exchange(number_, -1);
    if (::close(number) != 0) fail(name_);
  }

 private:
  int number_;
  std::filesystem::path name_;
};

// A device or pipe cannot be replaced by renaming; it is written to as it is.
bool is_written_in_place(const std::filesystem::path& file) {
  if (is_standard_output(file)) return true;
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

void write_in_place(const OutputFile& file) {
  const bool is_standard = is_standard_output(file.path);
  Descriptor descriptor(is_standard ? ::dup(STDOUT_FILENO) : ::open(file.path.c_str(), O_WRONLY | O_CLOEXEC),
                        is_standard ? "standard output" : file.path);
  descriptor.write(file.bytes);
  descriptor.close();
}

// The file that a link leads to is replaced, not the link.
std::filesystem::path real_target(std::filesystem::path file) {
  std::error_code error;
  constexpr int kMostLinks = 40;  // as many as the kernel follows
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(file, error); ++i) {
    const std::filesystem::path to = std::filesystem::read_symlink(file, error);
    if (error) break;
    file = file.parent_path() / to;
  }
  return file;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

// Writes the bytes beside `target` and returns their entry in the list.
Pending& write_beside(const std::filesystem::path& target, std::span<const std::byte> bytes) {
  Pending& entry = free_entry();
  int number = -1;
  for (int attempt = 0; number < 0; ++attempt) {
    const std::filesystem::path path =
        folder_of(target) / (".sweepkit-" + std::to_string(::getpid()) + "-" + std::to_string(attempt));
    if (path.native().size() >= kLongestPath) {
      errno = ENAMETOOLONG;
      fail(target);
    }
    // Listed before it is there: a handler between the two steps finds nothing to remove, which is no harm.
    std::memcpy(entry.path.data(), path.c_str(), path.native().size() + 1);
    entry.is_live = true;
    number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (number >= 0) break;
    entry.is_live = false;
    if (errno != EEXIST) fail(target);
  }
  Descriptor descriptor(number, target);
  struct stat before = {};
  if (::stat(target.c_str(), &before) == 0) descriptor.set_mode(before.st_mode & 07777);
  descriptor.write(bytes);
  descriptor.close();
  return entry;
}

}  // namespace

void check_output(const std::filesystem::path& file) {
  if (is_standard_output(file)) return;
  const auto refuse = [&](const std::string& problem) { throw InputError({.file = file.string()}, problem); };
  std::error_code ignored;
  if (file.empty() || file.filename().empty()) refuse("names no file to write");
  if (std::filesystem::is_directory(file, ignored)) refuse("is a folder; name a file in it");
  const std::filesystem::path target = real_target(file);
  const std::filesystem::path folder = folder_of(target);
  if (!std::filesystem::is_directory(folder, ignored)) {
    refuse("there is no folder " + folder.string() + "; make it first");
  }
  if (std::filesystem::exists(target, ignored) && ::access(target.c_str(), W_OK) != 0) {
    refuse(std::string("cannot be written: ") + std::strerror(errno));
  }
  if (!is_written_in_place(file) && ::access(folder.c_str(), W_OK | X_OK) != 0) {
    refuse("cannot be written: its folder: " + std::string(std::strerror(errno)));
  }
}

void write_files(std::span<const OutputFile> files) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  struct Rename {
    Pending* from;
    std::filesystem::path to;
  };
  std::vector<Rename> renames;
  try {
    for (const OutputFile& file : files) {
      if (is_written_in_place(file.path)) continue;
      const std::filesystem::path target = real_target(file.path);
      renames.push_back({&write_beside(target, file.bytes), target});
    }
    for (const OutputFile& file : files) {
      if (is_written_in_place(file.path)) write_in_place(file);
    }
    for (const auto& [from, to] : renames) {
      if (std::rename(from->path.data(), to.c_str()) != 0) fail(to);
      from->is_live = false;
    }
  } catch (...) {
    abandon_writes();
    throw;
  }
}

void abandon_writes() noexcept {
  for (Pending* entry = pending; entry != nullptr; entry = entry->next) {
    if (entry->is_live.exchange(false)) ::unlink(entry->path.data());
  }
}

}  // namespace sweepkit::scene
