// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace sweepkit::scene {

/// Cuts the decimal number off the text's start, correctly rounded: a sign, digits with a dot, an exponent.
/// Nothing, and the text as it was, where no number stands there; infinity where it overflows, 0 where it
/// vanishes. "nan" and "inf" are no numbers.
std::optional<double> take_number(std::string_view& text);

}  // namespace sweepkit::scene
