// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "json_value.hpp"

namespace sweepkit::scene {

/// The value on one line, keys in their order, each number the shortest that reads back the same, a whole one
/// below 2^53 without a point. The same value gives the same text, and parse_json() of it the same value.
/// Bytes that are no UTF-8 become U+FFFD.
std::string json_text(const JsonValue& value);

bool is_utf8(const std::string& text);

}  // namespace sweepkit::scene
