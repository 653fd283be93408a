// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>

namespace sweepkit::tools {

/// A bar on the terminal for work that takes over a second; nothing where standard error is no terminal.
class Progress {
 public:
  explicit Progress(bool is_quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// What the work is to call with its share done, 0 to 1, from one thread at a time; empty where no bar is
  /// wanted. Valid while this object lives.
  std::function<void(double)> callback();

  /// Takes the bar away, so that a line can be printed; the next call of the callback brings it back.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void draw(double done);

  bool is_wanted_;
  bool is_drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace sweepkit::tools
