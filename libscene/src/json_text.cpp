// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "json_text.hpp"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace sweepkit::scene {
namespace {

constexpr auto kReplace = nlohmann::json::error_handler_t::replace;

class Writer {
 public:
  void write(const JsonValue& value) {
    std::visit([this](const auto& data) { write_data(data); }, value.data);
  }

  std::string text;

 private:
  void write_data(std::nullptr_t) { text += "null"; }
  void write_data(bool value) { text += value ? "true" : "false"; }
  void write_data(double value) {
    constexpr double kWhole = 9007199254740992.0;  // 2^53
    const bool is_whole =
        std::abs(value) < kWhole && value == std::trunc(value) && !(value == 0 && std::signbit(value));
    text += is_whole ? nlohmann::json(static_cast<std::int64_t>(value)).dump() : nlohmann::json(value).dump();
  }
  void write_data(const std::string& value) { text += nlohmann::json(value).dump(-1, ' ', false, kReplace); }
  void write_data(const JsonValue::Array& items) {
    text += '[';
    for (const JsonValue& item : items) {
      if (&item != items.data()) text += ',';
      write(item);
    }
    text += ']';
  }
  void write_data(const JsonValue::Object& members) {
    text += '{';
    for (const JsonMember& member : members) {
      if (&member != members.data()) text += ',';
      write_data(member.key);
      text += ':';
      write(member.value);
    }
    text += '}';
  }
};

}  // namespace

std::string json_text(const JsonValue& value) {
  Writer writer;
  writer.write(value);
  return std::move(writer.text);
}

bool is_utf8(const std::string& text) {
  try {
    nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

}  // namespace sweepkit::scene
