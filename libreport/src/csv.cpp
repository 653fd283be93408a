// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>

#include "sweepkit/report/report.hpp"

namespace sweepkit::report {
namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string field(double number) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

}  // namespace

std::string to_csv(const Table& table) {
  std::string csv;
  for (const Column& column : table.columns) {
    if (!csv.empty()) csv += ',';
    csv += field(column.name);
  }
  csv += '\n';
  for (const std::vector<Cell>& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) csv += ',';
      csv += std::visit([](const auto& value) { return field(value); }, row[i]);
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace sweepkit::report
