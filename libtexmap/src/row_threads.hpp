// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace sweepkit::texmap {

/// Calls make_worker()(first, end) for bands of the rows 0 to count - 1, each once, in so many threads (0: as
/// many as the machine has); each thread makes a worker of its own. The first exception of any is thrown when
/// all have ended. Where the system gives fewer threads the work takes longer.
template <class MakeWorker>
void for_each_band(int count, int threads, const MakeWorker& make_worker) {
  constexpr int kRows = 16;  // few enough that all threads end together
  const int bands = (count + kRows - 1) / kRows;
  std::atomic<int> next = 0;
  std::mutex lock;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      auto worker = make_worker();
      for (int band = next++; band < bands; band = next++)
        worker(band * kRows, std::min(count, (band + 1) * kRows));
    } catch (...) {
      const std::lock_guard guard(lock);
      if (!failure) failure = std::current_exception();
      next = bands;
    }
  };
  if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  {
    std::vector<std::jthread> others;
    try {
      for (int i = 1; i < std::min(threads, bands); ++i) others.emplace_back(work);
    } catch (const std::system_error&) {
      // Those that there are do the work.
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace sweepkit::texmap
