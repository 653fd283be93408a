// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "report.hpp"
#include "sweepkit/scene/plan.hpp"

namespace sweepkit::tools {

/// --explain: a row for each part of the work - needed or not and why - and what it cost, once there is a
/// ledger.
Table plan_table(const scene::Plan& plan, const std::optional<scene::Ledger>& ledger);

}  // namespace sweepkit::tools
