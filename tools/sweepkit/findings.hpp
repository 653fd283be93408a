// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

#include "output.hpp"
#include "sweepkit/scene/check.hpp"

namespace sweepkit::tools {

/// check --strict has findings, and has told them.
class FoundFaults : public std::exception {
 public:
  const char* what() const noexcept override { return "findings"; }
};

/// Says each finding in a line on standard error, five at most and then how many more, unless it is to be
/// quiet.
void warn(const std::vector<scene::SceneFinding>& findings, const Output& output);

}  // namespace sweepkit::tools
