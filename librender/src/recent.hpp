// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "ray.hpp"

namespace sweepkit::render {

/// The items looked at last, so that one lying in several voxels is looked at once. A small direct-mapped
/// memory: a miss costs one more look and nothing else.
class Recent {
 public:
  bool add(std::uint32_t item) {
    std::uint32_t& slot = slots_[item % kSlots];
    if (slot == item) return false;
    slot = item;
    return true;
  }

 private:
  static constexpr std::size_t kSlots = 16;
  std::array<std::uint32_t, kSlots> slots_ = [] {
    std::array<std::uint32_t, kSlots> none{};
    none.fill(kNone);
    return none;
  }();
};

}  // namespace sweepkit::render
