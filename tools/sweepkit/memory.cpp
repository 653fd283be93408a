// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

namespace sweepkit::tools {

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

}  // namespace sweepkit::tools
