// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

/// A JSON value that knows where it stands.
struct JsonValue {
  using Array = std::vector<JsonValue>;
  using Object = std::vector<std::pair<std::string, JsonValue>>;  ///< in the file's order

  std::variant<std::nullptr_t, bool, double, std::string, Array, Object> data;
  const std::string* source = nullptr;  ///< the file's name, or the option's
  int line = 0;                         ///< 0: not from a file
  int column = 0;
};

const char* kind_name(const JsonValue& value);  ///< "a number", "an object", ...

struct JsonDocument {
  std::deque<std::string> sources;  ///< what the values' `source` look at
  JsonValue root;
};

/// JSON with // and /* */ comments. Throws InputError with line and column: bad syntax, a number that
/// overflows, a key twice in one object, nesting deeper than 64.
JsonDocument parse_json(const std::string& text, const std::string& file);

/// --set: replaces a value, adds a key, or appends with "-" (RFC 6901 pointers). Throws InputError naming the
/// option.
void apply_setting(JsonDocument& document, const Setting& setting);

}  // namespace sweepkit::scene
