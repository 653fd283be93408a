// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <string>

namespace sweepkit::sweep {

/// A number as a person would write it: "0.1", "1e-09", "-3" (std::to_string shows all three as six places).
inline std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

}  // namespace sweepkit::sweep
