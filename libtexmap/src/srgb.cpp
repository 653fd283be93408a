// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "srgb.hpp"

namespace sweepkit::texmap {
namespace {

std::vector<std::uint16_t> make_table() {
  std::vector<std::uint16_t> table(65536);
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] =
        static_cast<std::uint16_t>(std::lround(65535 * linear_from_srgb(static_cast<double>(i) / 65535)));
  }
  return table;
}

}  // namespace

const std::vector<std::uint16_t>& linear_from_srgb_table() {
  static const std::vector<std::uint16_t> table = make_table();
  return table;
}

}  // namespace sweepkit::texmap
