// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "plan_table.hpp"

namespace sweepkit::tools {

Table plan_table(const scene::Plan& plan, const std::optional<scene::Ledger>& ledger) {
  Table table{"parts", {}};
  for (std::size_t i = 0; i < scene::kPartCount; ++i) {
    const auto part = static_cast<scene::Part>(i);
    const scene::Need& need = plan.needs[i];
    Record row = {
        {"part", std::string(scene::part_name(part))}, {"needed", need.is_needed}, {"why", need.why}};
    if (ledger) {
      row.emplace_back("bytes", (*ledger)[part].bytes);
      row.emplace_back("calls", (*ledger)[part].calls);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace sweepkit::tools
