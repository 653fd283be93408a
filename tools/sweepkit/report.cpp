// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sweepkit::tools {
namespace {

std::string number_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

std::string plain(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "yes" : "no";
  if (const auto* whole = std::get_if<std::uint64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return number_text(*number);
  return "-";
}

std::string quoted(const std::string& text) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20) {
      out += "\\u00";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    } else {
      out += c;
    }
  }
  return out + '"';
}

}  // namespace

std::string json_value(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* number = std::get_if<double>(&value); number != nullptr && !std::isfinite(*number))
    return "null";
  return std::holds_alternative<std::monostate>(value) ? "null" : plain(value);
}

namespace {

bool is_number(const Value& value) {
  return std::holds_alternative<std::uint64_t>(value) || std::holds_alternative<double>(value);
}

// Columns as wide as their widest cell; numbers end in line, words begin in line.
std::string table_text(const Table& table) {
  const Record& first = table.rows.front();
  std::vector<std::size_t> widths;
  std::vector<bool> is_right;
  for (std::size_t column = 0; column < first.size(); ++column) {
    std::size_t width = first[column].first.size();
    bool has_number = false;
    for (const Record& row : table.rows) {
      width = std::max(width, plain(row[column].second).size());
      has_number |= is_number(row[column].second);
    }
    widths.push_back(width);
    is_right.push_back(has_number);
  }
  const auto line = [&](auto&& cell) {
    std::string out;
    for (std::size_t column = 0; column < widths.size(); ++column) {
      const std::string text = cell(column);
      const std::string space(widths[column] - text.size(), ' ');
      out += (column == 0 ? "" : "  ") + (is_right[column] ? space + text : text + space);
    }
    out.erase(out.find_last_not_of(' ') + 1);
    return out + '\n';
  };
  std::string out = line([&](std::size_t column) { return first[column].first; });
  for (const Record& row : table.rows) {
    out += line([&](std::size_t column) { return plain(row[column].second); });
  }
  return out;
}

std::string json_record(const Record& record) {
  std::string out = "{";
  for (const auto& [name, value] : record) {
    out += (out.size() > 1 ? ", " : "") + quoted(name) + ": " + json_value(value);
  }
  return out + "}";
}

}  // namespace

std::string to_text(const Report& report) {
  std::string out;
  for (const auto& [name, value] : report.facts) out += name + ": " + plain(value) + '\n';
  for (const Table& table : report.tables) {
    if (table.rows.empty()) continue;
    if (!out.empty()) out += '\n';
    out += table_text(table);
  }
  return out;
}

std::string to_json(const Report& report) {
  std::string out;
  for (const auto& [name, value] : report.facts) {
    out += (out.empty() ? "" : ",\n") + ("  " + quoted(name)) + ": " + json_value(value);
  }
  for (const Table& table : report.tables) {
    out += (out.empty() ? "" : ",\n") + ("  " + quoted(table.name)) + ": [";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      out += (i == 0 ? "\n    " : ",\n    ") + json_record(table.rows[i]);
    }
    out += table.rows.empty() ? "]" : "\n  ]";
  }
  return "{\n" + out + "\n}\n";
}

}  // namespace sweepkit::tools
