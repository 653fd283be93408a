// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "curve_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <initializer_list>
#include <span>
#include <string_view>

#include "sweepkit/error.hpp"

namespace sweepkit::tools {
namespace {

struct Primitive {
  const char* kind;
  std::array<const char*, 4> keys;  ///< in the order of values without names; nullptr after the last
};
constexpr Primitive kPrimitives[] = {
    {"circle", {"radius"}},
    {"ellipse", {"rx", "ry"}},
    {"rectangle", {"width", "height", "corner_radius"}},
    {"polygon", {"sides", "radius"}},
    {"star", {"points", "radius", "inner_radius"}},
    {"arc", {"radius", "from_deg", "to_deg"}},
    {"helix", {"radius", "pitch", "turns"}},
    {"torus_knot", {"p", "q", "radius", "tube"}},
};

struct FileKind {
  const char* extension;
  const char* kind;  ///< of curve in the scene format; nullptr: a CURVE itself
};
constexpr FileKind kFileKinds[] = {{".svg", "svg"}, {".csv", "csv"}, {".txt", "csv"},
                                   {".xyz", "csv"}, {".dat", "csv"}, {".json", nullptr}};

std::string kinds_text() {
  std::string kinds;
  for (const Primitive& primitive : kPrimitives) kinds += std::string(primitive.kind) + ", ";
  return kinds + "line, path";
}

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

[[noreturn]] void fail(const std::string& option, const std::string& problem) {
  throw InputError({.file = option}, problem);
}

scene::Setting json_setting(const std::string& pointer, std::string json, const std::string& option) {
  return {pointer, std::move(json), {.file = option}, {.file = option}};
}

bool ends_in(const std::string& text, const std::string& extension) {
  return text.size() > extension.size() &&
         text.compare(text.size() - extension.size(), extension.size(), extension) == 0;
}

const FileKind* kind_of_file(const std::string& name) {
  const auto* const found = std::find_if(std::begin(kFileKinds), std::end(kFileKinds),
                                         [&](const FileKind& kind) { return ends_in(name, kind.extension); });
  return found == std::end(kFileKinds) ? nullptr : found;
}

// key=value pairs as members of a JSON object. `keys` name values that stand alone.
std::string members(const std::string& arguments, std::span<const char* const> keys, const std::string& kind,
                    const std::string& option) {
  std::string json;
  std::size_t alone = 0;
  for (const std::string& argument : split(arguments, ',')) {
    const std::size_t equals = argument.find('=');
    const bool has_name = equals != std::string::npos;
    if (!has_name && (alone == keys.size() || keys[alone] == nullptr)) {
      fail(option,
           kind + " takes " +
               (alone == 0 ? "no value without a name (NAME=VALUE)"
                           : "at most " + std::to_string(alone) + (alone == 1 ? " value" : " values")) +
               ", got \"" + argument + "\"");
    }
    const std::string key = has_name ? argument.substr(0, equals) : keys[alone++];
    const std::string value = has_name ? argument.substr(equals + 1) : argument;
    const bool is_plain = is_number(value) || value == "true" || value == "false";
    if (!json.empty()) json += ", ";
    json += json_string(key);
    json += ": ";
    json += is_plain ? value : json_string(value);
  }
  return json;
}

std::string line_json(const std::string& arguments, const std::string& option) {
  const std::vector<std::string> numbers = split(arguments, ',');
  const bool are_numbers = std::all_of(numbers.begin(), numbers.end(), is_number);
  if (!are_numbers || (numbers.size() != 4 && numbers.size() != 6)) {
    fail(option, "a line is line:X,Y,X,Y or line:X,Y,Z,X,Y,Z, got \"line:" + arguments + "\"");
  }
  std::string json;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool is_second = i == numbers.size() / 2;
    json += i == 0 ? "[[" : is_second ? "], [" : ", ";
    json += numbers[i];
  }
  return joined({"{\"line\": ", json, "]]}"});
}

}  // namespace

bool is_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return false;
  // JSON's numbers begin and end with a digit, and a 0 only where it stands alone before the point.
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const std::string unsigned_text = text.substr(text.front() == '-' ? 1 : 0);
  const bool has_idle_zero =
      unsigned_text.size() > 1 && unsigned_text[0] == '0' && is_digit(unsigned_text[1]);
  return is_digit(text.back()) && is_digit(unsigned_text.front()) && !has_idle_zero;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  std::size_t from = 0;
  for (;;) {
    const std::size_t to = text.find(separator, from);
    parts.push_back(text.substr(from, to - from));
    if (to == std::string::npos) return parts;
    from = to + 1;
  }
}

std::string json_string(const std::string& text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      json += '\\';
      json += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", c);
      json += escape;
    } else {
      json += c;
    }
  }
  return json + '"';
}

scene::Setting curve_setting(const std::string& text, const std::string& pointer, const std::string& option) {
  if (text.starts_with('{')) {
    scene::Setting setting = json_setting(pointer, text, option);
    setting.form = scene::Setting::Form::kJson;
    return setting;
  }
  // A file's name may hold colons: what belongs to it comes after the last.
  const std::size_t last = text.rfind(':');
  const bool has_arguments = last != std::string::npos && kind_of_file(text) == nullptr;
  std::string name = text;
  std::string arguments;
  if (has_arguments) {
    name = text.substr(0, last);
    arguments = text.substr(last + 1);
  }
  std::string id;
  const std::size_t hash = name.rfind(".svg#");
  if (hash != std::string::npos) {
    id = name.substr(hash + 5);
    name.resize(hash + 4);
  }
  if (const FileKind* file = kind_of_file(name)) {
    if (file->kind == nullptr) {
      if (has_arguments)
        fail(option, "a curve of JSON takes nothing after its name, got \"" + arguments + '"');
      scene::Setting setting = json_setting(pointer, name, option);
      setting.form = scene::Setting::Form::kJsonFile;
      return setting;
    }
    const std::string more = members(arguments, {}, file->kind, option);
    std::string json = joined({"{", json_string(file->kind), ": ", json_string(name)});
    if (!id.empty()) json += joined({", \"id\": ", json_string(id)});
    if (has_arguments) json += joined({", ", members(arguments, {}, file->kind, option)});
    return json_setting(pointer, json + "}", option);
  }
  const std::size_t first = text.find(':');
  const std::string kind = text.substr(0, first);
  const std::string rest = first == std::string::npos ? "" : text.substr(first + 1);
  if (kind == "path") return json_setting(pointer, joined({"{\"path\": ", json_string(rest), "}"}), option);
  if (kind == "line") return json_setting(pointer, line_json(rest, option), option);
  const auto* const primitive =
      std::find_if(std::begin(kPrimitives), std::end(kPrimitives),
                   [&](const Primitive& candidate) { return kind == candidate.kind; });
  if (primitive == std::end(kPrimitives)) {
    fail(option, "needs a file (.svg .csv .txt .xyz .dat .json), JSON or a primitive (" + kinds_text() +
                     "), got \"" + text + '"');
  }
  return json_setting(
      pointer, joined({"{", json_string(kind), ": {", members(rest, primitive->keys, kind, option), "}}"}),
      option);
}

scene::Setting law_setting(const std::string& text, const std::string& pointer, const std::string& option) {
  scene::Setting setting = json_setting(pointer, text, option);
  if (is_number(text)) return setting;
  if (text.starts_with('{') || ends_in(text, ".json")) {
    setting.form = text.starts_with('{') ? scene::Setting::Form::kJson : scene::Setting::Form::kJsonFile;
    return setting;
  }
  std::string points;
  for (const std::string& point : split(text, ',')) {
    const std::vector<std::string> pair = split(point, ':');
    if (pair.size() != 2 || !is_number(pair[0]) || !is_number(pair[1])) {
      fail(option,
           "needs a number, values along the way such as 0:1,0.5:0.3,1:1, a .json file or JSON, got \"" +
               text + '"');
    }
    points += points.empty() ? "[" : ", [";
    points += pair[0];
    points += ", ";
    points += pair[1];
    points += ']';
  }
  setting.value = joined({"{\"points\": [", points, "]}"});
  return setting;
}

}  // namespace sweepkit::tools
