// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <string>
#include <variant>
#include <vector>

#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

struct JsonMember;

/// Where a token begins. `source` is the file's name, or the option's.
struct JsonPlace {
  const std::string* source = nullptr;
  int line = 0;  ///< 0: not from a file
  int column = 0;
};

/// A JSON value that knows where it stands.
struct JsonValue {
  using Array = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;  ///< in the file's order

  std::variant<std::nullptr_t, bool, double, std::string, Array, Object> data;
  JsonPlace place;
};

struct JsonMember {
  std::string key;
  JsonPlace key_place;
  JsonValue value;
};

const char* kind_name(const JsonValue& value);  ///< "a number", "an object", ...

struct JsonDocument {
  std::deque<std::string> sources;  ///< what the places' `source` look at
  JsonValue root;
};

/// JSON with // and /* */ comments. Throws InputError with line and column: bad syntax, a number that
/// overflows, a key twice in one object, nesting deeper than 64.
JsonDocument parse_json(const std::string& text, const std::string& file);
JsonValue parse_json_value(const std::string& text, const std::string& source);

/// Replaces a value, adds a key, or appends with "-" (RFC 6901 pointers). Throws InputError at the setting's
/// pointer.
void apply_setting(JsonDocument& document, const Setting& setting);

}  // namespace sweepkit::scene
