// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "findings.hpp"

#include <cstdio>

#include <algorithm>
#include <string>

namespace sweepkit::tools {

void warn(const std::vector<scene::SceneFinding>& findings, const Output& output) {
  constexpr std::size_t kMost = 5;
  for (std::size_t i = 0; i < std::min(findings.size(), kMost); ++i) {
    const sweep::Finding& f = findings[i].finding;
    char t[32];
    std::snprintf(t, sizeof t, "%.3g", f.t);
    // As an error's line: the place, what is wrong, what to do.
    const InputError line(findings[i].place,
                          findings[i].object + " at t = " + t + ": " + f.problem + "; " + f.cure);
    say("warning: " + std::string(line.what()), output);
  }
  if (findings.size() > kMost) {
    say("warning: " + std::to_string(findings.size() - kMost) + " more; see sweepkit check", output);
  }
}

}  // namespace sweepkit::tools
