// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "first_touch.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>

namespace sweepkit::sweep {

void prepare_first_touch([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  constexpr std::uintptr_t kPage = 4096;
  constexpr std::size_t kHugePage = std::size_t{2} << 20;
  constexpr std::size_t kWorthwhile = 64 * kPage;
  constexpr int kPopulateWrite = 23;  // MADV_POPULATE_WRITE, Linux 5.14, which glibc 2.36 does not name
  if (bytes < kWorthwhile) return;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + kPage - 1) / kPage * kPage;
  const std::uintptr_t end = (begin + bytes) / kPage * kPage;
  if (first >= end) return;
  // What they answer does not matter: without them the memory is as good, only slower to touch.
  if (bytes >= 2 * kHugePage) (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
  (void)madvise(reinterpret_cast<void*>(first), end - first, kPopulateWrite);
#endif
}

}  // namespace sweepkit::sweep
