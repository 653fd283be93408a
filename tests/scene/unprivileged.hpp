// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <filesystem>

namespace sweepkit::scene {

/// While it lives, root may no more than anyone: root reads and writes what it likes, so that missing rights
/// could not be tried. What is `mine` is given away first, for the test to work in.
class Unprivileged {
 public:
  explicit Unprivileged(const std::filesystem::path& mine) {
    is_root_ = ::geteuid() == 0;
    if (!is_root_) return;
    is_sound_ = ::chown(mine.c_str(), kNobody, kNobody) == 0;
    for (const auto& entry : std::filesystem::directory_iterator(mine)) {
      is_sound_ &= ::chown(entry.path().c_str(), kNobody, kNobody) == 0;
    }
    is_sound_ &= ::setresuid(kNobody, kNobody, 0) == 0;
  }
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;
  ~Unprivileged() {
    if (is_root_ && ::setresuid(0, 0, 0) != 0) std::terminate();
  }

  bool is_sound() const { return is_sound_; }

 private:
  static constexpr uid_t kNobody = 65534;
  bool is_root_ = false;
  bool is_sound_ = true;
};

}  // namespace sweepkit::scene
