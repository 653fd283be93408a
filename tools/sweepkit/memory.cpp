// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

#include "sweepkit/error.hpp"

namespace sweepkit::tools {
namespace {

// A line such as "VmData:   1234 kB" of a file under /proc, in bytes.
std::optional<std::uint64_t> kilobytes_in(const char* file, std::string_view key) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(key)) return std::strtoull(line.c_str() + key.size(), nullptr, 10) << 10;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> number_in(const std::filesystem::path& file) {
  std::uint64_t number = 0;
  if (std::ifstream(file) >> number) return number;
  return std::nullopt;  // none, or "max"
}

std::uint64_t minus(std::uint64_t limit, std::uint64_t used) {
  return limit - std::min(limit, used);
}

// Of the process's own group and of those above it, as far as they are seen from here.
void look_at_groups(MemoryLeft& left) {
  const auto look = [&](std::filesystem::path folder, const std::filesystem::path& root, const char* limit,
                        const char* used) {
    for (;; folder = folder.parent_path()) {
      const std::optional<std::uint64_t> most = number_in(folder / limit);
      const std::optional<std::uint64_t> now = number_in(folder / used);
      if (most && now && minus(*most, *now) < left.bytes) left = {minus(*most, *now), "its control group"};
      if (folder == root || !folder.has_relative_path()) return;
    }
  };
  std::ifstream lines("/proc/self/cgroup");
  for (std::string line; std::getline(lines, line);) {
    const std::size_t path = line.find(":/");
    if (path == std::string::npos) continue;
    const std::string group = line.substr(path + 2);
    if (line.starts_with("0::")) {
      const std::filesystem::path root = "/sys/fs/cgroup";
      look(group.empty() ? root : root / group, root, "memory.max", "memory.current");
    } else if (line.find(":memory:") != std::string::npos) {
      const std::filesystem::path root = "/sys/fs/cgroup/memory";
      look(group.empty() ? root : root / group, root, "memory.limit_in_bytes", "memory.usage_in_bytes");
    }
  }
}

// Under AddressSanitizer limits say nothing (memory_left).
[[maybe_unused]] void look_at_limit(MemoryLeft& left, __rlimit_resource resource, const char* used,
                                    const char* name) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  const std::uint64_t bytes = minus(limit.rlim_cur, kilobytes_in("/proc/self/status", used).value_or(0));
  if (bytes < left.bytes) left = {bytes, name};
}

std::string size_text(std::uint64_t bytes) {
  char text[32];
  const double mebibytes = static_cast<double>(bytes) / (1 << 20);
  if (mebibytes < 1000) {
    std::snprintf(text, sizeof text, "%.0f MiB", mebibytes);
  } else {
    std::snprintf(text, sizeof text, "%.1f GiB", mebibytes / 1024);
  }
  return text;
}

}  // namespace

void limit_memory() {
#ifndef __SANITIZE_ADDRESS__  // AddressSanitizer reserves terabytes that it never uses
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page = sysconf(_SC_PAGESIZE);
  rlimit limit{};
  if (pages <= 0 || page <= 0 || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  const rlim_t machine = static_cast<rlim_t>(pages) * static_cast<rlim_t>(page);
  if (limit.rlim_cur != RLIM_INFINITY && limit.rlim_cur <= machine) return;
  limit.rlim_cur = machine;
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

MemoryLeft memory_left() {
  MemoryLeft left{std::numeric_limits<std::uint64_t>::max(), "this machine"};
  if (const auto available = kilobytes_in("/proc/meminfo", "MemAvailable:"))
    left.bytes = *available + kilobytes_in("/proc/meminfo", "SwapFree:").value_or(0);
  look_at_groups(left);
#ifndef __SANITIZE_ADDRESS__
  look_at_limit(left, RLIMIT_AS, "VmSize:", "ulimit -v");
  look_at_limit(left, RLIMIT_DATA, "VmData:", "ulimit -d");
#endif
  return left;
}

void require_memory(const std::string& name, const scene::MemoryEstimate& estimate, std::uint64_t more) {
  const std::uint64_t needed = estimate.bytes + more;
  // Small enough for any machine, and the files under /proc are not read for nothing.
  constexpr std::uint64_t kNeverShort = std::uint64_t{16} << 20;
  if (needed < kNeverShort) return;
  const MemoryLeft left = memory_left();
  if (needed <= left.bytes) return;
  throw InputError({.file = name},
                   "needs about " + size_text(needed) + " of memory, for " +
                       std::to_string(estimate.triangles) + " triangles, " +
                       std::to_string(estimate.objects) + (estimate.objects == 1 ? " object" : " objects") +
                       " and what is made of them, and " + left.bound + " leaves " + size_text(left.bytes) +
                       "; ask for fewer cells or pixels, or run it where there is more");
}

void limit_triangles(scene::Document& document, std::uint64_t more_a_triangle) {
  std::optional<std::uint64_t> most;
  for (scene::ObjectEntry& object : document.objects) {
    for (scene::Piece& piece : object.pieces) {
      if (!piece.tessellation.tolerance) continue;
      if (!most) most = memory_left().bytes / (scene::kLeastBytesATriangle + more_a_triangle);
      piece.tessellation.most_triangles = std::min(piece.tessellation.most_triangles, *most);
    }
  }
}

}  // namespace sweepkit::tools
