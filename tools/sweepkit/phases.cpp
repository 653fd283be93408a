// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "phases.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace sweepkit::tools {
namespace {

std::uint64_t resident_memory() {
  std::uint64_t pages = 0;
  std::uint64_t resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * static_cast<std::uint64_t>(std::max(0L, sysconf(_SC_PAGESIZE)));
}

}  // namespace

std::uint64_t peak_memory() {
  rusage used{};
  if (getrusage(RUSAGE_SELF, &used) != 0) return 0;
  return std::uint64_t{1024} * static_cast<std::uint64_t>(used.ru_maxrss);
}

void Phases::end(Phase phase, std::optional<double> seconds) {
  const Clock::time_point now = Clock::now();
  Share& share = shares_[static_cast<std::size_t>(phase)];
  share.seconds += seconds.value_or(std::chrono::duration<double>(now - last_).count());
  // The kernel counts both loosely; neither is ever above the peak.
  share.resident_bytes = std::max(share.resident_bytes, resident_memory());
  share.peak_bytes = std::max(peak_memory(), share.resident_bytes);
  last_ = now;
}

Table Phases::table() const {
  static constexpr const char* kNames[] = {"reading", "meshes",   "textures", "accelerators",
                                           "picture", "encoding", "writing"};
  Table table{"phases", {}};
  for (std::size_t i = 0; i < kPhaseCount; ++i) {
    table.rows.push_back({{"phase", std::string(kNames[i])},
                          {"seconds", shares_[i].seconds},
                          {"resident_bytes", shares_[i].resident_bytes},
                          {"peak_bytes", shares_[i].peak_bytes}});
  }
  return table;
}

}  // namespace sweepkit::tools
