// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include <algorithm>

#include "json_value.hpp"
#include "message_text.hpp"
#include "sweepkit/error.hpp"
#include "text_file.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kMostFileBytes = std::size_t{64} << 20;

// RFC 6901: parts after each "/", ~1 for "/" and ~0 for "~".
std::vector<std::string> split_pointer(const std::string& pointer, const Place& place) {
  if (pointer.empty() || pointer[0] != '/') {
    throw InputError(place, "a pointer begins with \"/\" (/objects/0/name), got " + in_quotes(pointer));
  }
  std::vector<std::string> parts(1);
  for (std::size_t i = 1; i < pointer.size(); ++i) {
    if (pointer[i] == '/') {
      parts.emplace_back();
    } else if (pointer[i] == '~') {
      const char escape = i + 1 < pointer.size() ? pointer[++i] : '\0';
      if (escape != '0' && escape != '1') {
        throw InputError(place, "in a pointer \"~\" is written ~0 and \"/\" ~1, got " + in_quotes(pointer));
      }
      parts.back() += escape == '0' ? '~' : '/';
    } else {
      parts.back() += pointer[i];
    }
  }
  return parts;
}

// All of a setting's value stands where the setting does: line and column inside an option's value or a
// table's cell would say little.
void mark_as_setting(JsonValue& value, const JsonPlace& place) {
  value.place = place;
  if (auto* array = std::get_if<JsonValue::Array>(&value.data)) {
    for (JsonValue& item : *array) mark_as_setting(item, place);
  } else if (auto* object = std::get_if<JsonValue::Object>(&value.data)) {
    for (JsonMember& member : *object) {
      member.key_place = place;
      mark_as_setting(member.value, place);
    }
  }
}

JsonPlace to_json_place(JsonDocument& document, const Place& place) {
  return {&document.sources.emplace_back(place.file), place.line, place.column};
}

JsonValue value_of(JsonDocument& document, const Setting& setting) {
  if (setting.form == Setting::Form::kJsonFile) {
    const std::string& source = document.sources.emplace_back(setting.value);
    return parse_json_value(read_text_file(source, kMostFileBytes, "a file of JSON"), source);
  }
  const JsonPlace place = to_json_place(document, setting.place);
  if (setting.form == Setting::Form::kJson) return parse_json_value(setting.value, *place.source);
  JsonValue value;
  try {
    value = parse_json_value(setting.value, *place.source);
  } catch (const InputError&) {
    value.data = setting.value;  // not JSON: a plain string, so that no shell needs two kinds of quotes
  }
  mark_as_setting(value, place);
  return value;
}

// No leading zero, no sign; nine digits are more than any array has.
bool is_index(const std::string& part) {
  return !part.empty() && part.size() < 10 && part.find_first_not_of("0123456789") == std::string::npos &&
         (part.size() == 1 || part[0] != '0');
}

std::string range_of(const JsonValue::Array& array, const std::string& name) {
  if (array.empty()) return name + " is empty; append with \"-\"";
  return name + " has the entries 0 to " + std::to_string(array.size() - 1) + "; append with \"-\"";
}

}  // namespace

void apply_setting(JsonDocument& document, const Setting& setting) {
  JsonValue value = value_of(document, setting);

  const std::vector<std::string> parts = split_pointer(setting.pointer, setting.pointer_place);
  const auto fail = [&](const std::string& problem) {
    Place at_fault = setting.pointer_place;
    at_fault.pointer = one_line(setting.pointer);
    throw InputError(at_fault, problem);
  };
  JsonValue* at = &document.root;
  std::string so_far;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_last = i + 1 == parts.size();
    const std::string& part = parts[i];
    const std::string name = so_far.empty() ? "the scene" : one_line(so_far);
    if (auto* object = std::get_if<JsonValue::Object>(&at->data)) {
      const auto member = std::find_if(object->begin(), object->end(),
                                       [&](const JsonMember& entry) { return entry.key == part; });
      if (member != object->end()) {
        at = &member->value;
      } else if (is_last) {
        at =
            &object->emplace_back(JsonMember{part, to_json_place(document, setting.pointer_place), {}}).value;
      } else {
        fail("there is no " + in_quotes(part) + " in " + name + "; set that first");
      }
    } else if (auto* array = std::get_if<JsonValue::Array>(&at->data)) {
      if (part == "-" && is_last) {
        at = &array->emplace_back();
      } else if (is_index(part) && std::stoul(part) < array->size()) {
        at = &(*array)[std::stoul(part)];
      } else {
        fail("there is no entry " + in_quotes(part) + ": " + range_of(*array, name));
      }
    } else {
      fail(name + " is " + kind_name(*at) + " and has no " + in_quotes(part));
    }
    so_far += "/" + part;
  }
  *at = std::move(value);
}

}  // namespace sweepkit::scene
