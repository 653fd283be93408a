// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Files are written under another name in their own folder, so that the rename at the end stays on one disk
// and is one step. What is on the disk meanwhile is listed where a signal handler can read it.
//
// Several threads may write. The handler runs on one of them while the others go on, so names come to the
// disk and leave it inside short sections that a signal cannot enter; the handler closes the gate to new
// ones, waits for those under way, and only then removes what the list holds.

#include "sweepkit/scene/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <utility>
#include <vector>

#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kLongestPath = 4096;

// One name on the disk. Entries are never given back, only used again: a handler may be reading the list at
// any moment.
struct Pending {
  std::array<char, kLongestPath> path;
  std::atomic<bool> is_taken = false;  // by a write
  std::atomic<bool> is_live = false;   // may be on the disk
  Pending* next = nullptr;
};
std::atomic<Pending*> pending = nullptr;

std::atomic<bool> is_abandoned = false;
std::atomic<int> sections = 0;

// A section of the work during which this thread takes no signal. Nothing enters once writes are abandoned:
// the process is about to end.
class Section {
 public:
  Section() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
    ++sections;
    if (!is_abandoned) return;
    --sections;
    while (true) ::pause();
  }
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;
  ~Section() {
    --sections;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t before_;
};

Pending& take_entry() {
  for (Pending* entry = pending; entry != nullptr; entry = entry->next) {
    if (!entry->is_taken.exchange(true)) return *entry;
  }
  auto* entry = new Pending;
  entry->is_taken = true;
  entry->next = pending;
  while (!pending.compare_exchange_weak(entry->next, entry)) {
  }
  return *entry;
}

// A file beside its place: removed again unless it is renamed.
class FileBeside {
 public:
  FileBeside() : entry_(&take_entry()) {}
  FileBeside(FileBeside&& other) noexcept : entry_(std::exchange(other.entry_, nullptr)) {}
  FileBeside& operator=(FileBeside&&) = delete;
  ~FileBeside() {
    if (entry_ == nullptr) return;
    if (entry_->is_live) {
      const Section section;
      ::unlink(entry_->path.data());
      entry_->is_live = false;
    }
    entry_->is_taken = false;
  }

  // A new file's descriptor, or -1 with errno.
  int open(const std::filesystem::path& path) const {
    if (path.native().size() >= kLongestPath) {
      errno = ENAMETOOLONG;
      return -1;
    }
    const Section section;
    std::memcpy(entry_->path.data(), path.c_str(), path.native().size() + 1);
    const int number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    entry_->is_live = number >= 0;
    return number;
  }
  bool rename(const std::filesystem::path& to) const {
    if (std::rename(entry_->path.data(), to.c_str()) != 0) return false;
    entry_->is_live = false;
    return true;
  }

 private:
  Pending* entry_;
};

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
  void write(const OutputFile& file) const {
    write(file.bytes);
    for (const std::span<const std::byte> piece : file.more) write(piece);
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
  descriptor.write(file);
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

FileBeside write_beside(const std::filesystem::path& target, const OutputFile& content) {
  static std::atomic<unsigned> names = 0;
  FileBeside file;
  int number = -1;
  while (number < 0) {
    number = file.open(folder_of(target) /
                       (".sweepkit-" + std::to_string(::getpid()) + "-" + std::to_string(names++)));
    if (number < 0 && errno != EEXIST) fail(target);
  }
  Descriptor descriptor(number, target);
  struct stat before = {};
  if (::stat(target.c_str(), &before) == 0) descriptor.set_mode(before.st_mode & 07777);
  descriptor.write(content);
  descriptor.close();
  return file;
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

struct StagedFiles::Parts {
  std::vector<std::pair<FileBeside, std::filesystem::path>> renames;
  std::vector<OutputFile> in_place;
};

StagedFiles::StagedFiles() : parts_(std::make_unique<Parts>()) {}
StagedFiles::~StagedFiles() = default;

void StagedFiles::add(const OutputFile& file) {
  if (is_written_in_place(file.path)) {
    parts_->in_place.push_back(file);
    return;
  }
  std::filesystem::path target = real_target(file.path);
  FileBeside beside = write_beside(target, file);
  parts_->renames.emplace_back(std::move(beside), std::move(target));
}

void StagedFiles::put_in_place() {
  for (const OutputFile& file : parts_->in_place) write_in_place(file);
  const Section section;  // all of the set or none
  for (const auto& [beside, target] : parts_->renames) {
    if (!beside.rename(target)) fail(target);
  }
}

void write_files(std::span<const OutputFile> files) {
  StagedFiles staged;
  for (const OutputFile& file : files) staged.add(file);
  staged.put_in_place();
}

void abandon_writes() noexcept {
  is_abandoned = true;
  // A section is one or two system calls. A disk that does not answer may leave a file behind; a Ctrl-C that
  // does not answer would be worse.
  constexpr int kMostWaits = 2000;
  constexpr timespec kWait{.tv_sec = 0, .tv_nsec = 1'000'000};
  for (int i = 0; i < kMostWaits && sections > 0; ++i) ::nanosleep(&kWait, nullptr);
  for (Pending* entry = pending; entry != nullptr; entry = entry->next) {
    if (entry->is_live.exchange(false)) ::unlink(entry->path.data());
  }
}

}  // namespace sweepkit::scene
