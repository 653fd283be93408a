// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace sweepkit::tools {
namespace {

constexpr std::chrono::seconds kPatience{1};             // shorter work is over before a bar helps
constexpr std::chrono::milliseconds kBetweenDraws{100};  // no faster than eyes follow
constexpr int kCells = 40;

}  // namespace

Progress::Progress(bool is_quiet) : is_wanted_(!is_quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  clear();
}

void Progress::clear() {
  if (is_drawn_) std::fputs("\r\x1b[K", stderr);
  is_drawn_ = false;
}

std::function<void(double)> Progress::callback() {
  if (!is_wanted_) return {};
  return [this](double done) { draw(done); };
}

void Progress::draw(double done) {
  const Clock::time_point now = Clock::now();
  if (now - start_ < kPatience || (is_drawn_ && now - last_ < kBetweenDraws)) return;
  last_ = now;
  is_drawn_ = true;
  const double share = std::clamp(done, 0.0, 1.0);
  const int full = static_cast<int>(share * kCells);
  std::string bar(static_cast<std::size_t>(full), '#');
  bar.append(static_cast<std::size_t>(kCells - full), '.');
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = share > 0 ? elapsed * (1 - share) / share : 0;
  std::fprintf(stderr, "\r[%s] %3.0f%%, %.0f s left\x1b[K", bar.c_str(), 100 * share, left);
}

}  // namespace sweepkit::tools
