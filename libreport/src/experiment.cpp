// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/report/experiment.hpp"

#include <algorithm>
#include <cassert>

namespace sweepkit::report {

std::size_t Table::column(const std::string& name) const {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const Column& one) { return one.name == name; });
  assert(found != columns.end());
  return static_cast<std::size_t>(found - columns.begin());
}

}  // namespace sweepkit::report
