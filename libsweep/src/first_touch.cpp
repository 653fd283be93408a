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
  constexpr std::size_t kPage = 4096;
  constexpr std::size_t kHugePage = std::size_t{2} << 20;
  constexpr std::size_t kWorthwhile = 64 * kPage;
  constexpr int kPopulateWrite = 23;  // MADV_POPULATE_WRITE, Linux 5.14, which glibc 2.36 does not name
  if (bytes < kWorthwhile) return;
  // Whole pages: from the first that begins inside to the last that ends inside.
  auto* bytes_of = static_cast<std::byte*>(memory);
  const std::size_t skipped = (kPage - reinterpret_cast<std::uintptr_t>(memory) % kPage) % kPage;
  if (bytes < skipped + kPage) return;
  std::byte* first = bytes_of + skipped;
  const std::size_t length = (bytes - skipped) / kPage * kPage;
  // What they answer does not matter: without them the memory is as good, only slower to touch.
  if (bytes >= 2 * kHugePage) (void)madvise(first, length, MADV_HUGEPAGE);
  (void)madvise(first, length, kPopulateWrite);
#endif
}

}  // namespace sweepkit::sweep
