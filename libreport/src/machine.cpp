// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <sys/utsname.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <thread>

#include "sweepkit/report/report.hpp"

namespace sweepkit::report {
namespace {

// The value of the first line that begins with `key`, of a file such as /proc/cpuinfo; "" without one.
std::string value_in(const char* file, const std::string& key) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t start = line.find_first_not_of(" \t:=\"", key.size());
    if (start == std::string::npos) return "";
    return line.substr(start, line.find_last_not_of(" \t\"") + 1 - start);
  }
  return "";
}

}  // namespace

Machine this_machine() {
  Machine machine;
  machine.processor = value_in("/proc/cpuinfo", "model name");
  machine.threads = std::thread::hardware_concurrency();
  const double bytes =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  machine.memory_gib = std::round(bytes / (1 << 30) * 10) / 10;
  ::utsname system{};
  ::uname(&system);
  machine.system = value_in("/etc/os-release", "PRETTY_NAME");
  if (machine.system.empty()) machine.system = system.sysname;
  machine.system += std::string(", ") + system.sysname + " " + system.release;
#if defined(__clang__)
  machine.compiler = "clang " __clang_version__;
#else
  machine.compiler = "GCC " __VERSION__;
#endif
#if !defined(__OPTIMIZE__)
  machine.compiler += ", not optimized";
#endif
  return machine;
}

}  // namespace sweepkit::report
