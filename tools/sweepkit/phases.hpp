// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "report.hpp"

namespace sweepkit::tools {

/// The parts of the time that `render` takes, in their order.
enum class Phase { kReading, kMeshes, kTextures, kAccelerators, kPicture, kEncoding, kWriting };
inline constexpr std::size_t kPhaseCount = static_cast<std::size_t>(Phase::kWriting) + 1;

/// The most memory that the program has held so far, bytes; 0 where the system does not tell.
std::uint64_t peak_memory();

/// How long each phase took on the wall, and the memory at its end.
class Phases {
 public:
  /// What has passed since the last call, or since this was made, belongs to `phase`. `seconds` instead,
  /// where the work itself has counted.
  void end(Phase phase, std::optional<double> seconds = std::nullopt);

  Table table() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Share {
    double seconds = 0;
    std::uint64_t resident_bytes = 0;
    std::uint64_t peak_bytes = 0;
  };

  Clock::time_point last_ = Clock::now();
  std::array<Share, kPhaseCount> shares_;
};

}  // namespace sweepkit::tools
