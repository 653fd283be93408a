// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sweepkit::tools {

/// A number or a word that a command tells; nothing where there is none.
using Value = std::variant<std::monostate, bool, std::uint64_t, double, std::string>;
using Record = std::vector<std::pair<std::string, Value>>;

struct Table {
  std::string name;          ///< "objects"
  std::vector<Record> rows;  ///< all with the same names in the same order
};

/// What a command tells about a thing: a few facts, then tables. One form for people, one for programs, so
/// that neither can know more than the other.
struct Report {
  Record facts;
  std::vector<Table> tables;
};

/// Facts a line, tables in columns, ending with a newline.
std::string to_text(const Report& report);

/// A value as JSON has it.
std::string json_value(const Value& value);

/// One JSON object: the facts, and an array of objects for each table.
std::string to_json(const Report& report);

}  // namespace sweepkit::tools
