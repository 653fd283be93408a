// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// nlohmann/json does the parsing, by its event interface; places come from counting what it has read. When an
// event arrives the lexer has read to the token's end - one byte past it for numbers, which end at the byte
// that is none. A token's start is found from the last one's end by skipping what may stand between: white
// space, commas, colons, comments.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "json_value.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kDeepest = 64;

struct LineColumn {
  int line, column;
};

LineColumn line_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n');
  const std::size_t last_break = before.rfind('\n');
  const std::size_t column =
      last_break == std::string_view::npos ? before.size() : before.size() - last_break - 1;
  return {static_cast<int>(line) + 1, static_cast<int>(column) + 1};
}

// An input iterator that leaves behind how far it was read.
class CountingIterator {
 public:
  using difference_type = std::ptrdiff_t;
  using value_type = char;
  using pointer = const char*;
  using reference = const char&;
  using iterator_category = std::input_iterator_tag;

  CountingIterator(const char* at, const char** farthest) : at_(at), farthest_(farthest) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    *farthest_ = std::max(*farthest_, ++at_);
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  const char** farthest_;
};

class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const std::string& source, const char* const& farthest)
      : text_(text), source_(source), farthest_(farthest) {}

  JsonValue take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(static_cast<double>(value), true); }
  bool number_unsigned(number_unsigned_t value) override { return add(static_cast<double>(value), true); }
  bool number_float(number_float_t value, const string_t&) override { return add(value, true); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonValue::Object{}); }
  bool start_array(std::size_t) override { return open(JsonValue::Array{}); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    const LineColumn at = next_token(false);
    const auto& object = std::get<JsonValue::Object>(open_.back()->data);
    if (std::any_of(object.begin(), object.end(), [&](const auto& member) { return member.first == name; })) {
      fail(at, "\"" + name + "\" stands twice in this object; leave one out");
    }
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception& error) override {
    std::string what = error.what();
    const LineColumn at = line_column(text_, position > 0 ? position - 1 : 0);
    if (const std::size_t number = what.find("number overflow parsing "); number != std::string::npos) {
      fail(next_token(true), "the number " + what.substr(number + 24) + " is too large");
    }
    if (const std::size_t start = what.find("syntax error"); start != std::string::npos)
      what = what.substr(start);
    std::replace(what.begin(), what.end(), '\n', ' ');
    fail(at, "not valid JSON: " + what);
  }

 private:
  [[noreturn]] void fail(LineColumn at, std::string problem) const {
    throw InputError({.file = source_, .line = at.line, .column = at.column}, std::move(problem));
  }

  std::size_t skip_between(std::size_t offset) const {
    while (offset < text_.size()) {
      const char c = text_[offset];
      if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ':' || c == '\xEF' ||
          c == '\xBB' || c == '\xBF') {
        ++offset;
      } else if (c == '/' && offset + 1 < text_.size()) {
        const bool is_line = text_[offset + 1] == '/';
        const std::size_t end = text_.find(is_line ? "\n" : "*/", offset + 2);
        if (end == std::string_view::npos) return text_.size();
        offset = end + (is_line ? 1 : 2);
      } else {
        break;
      }
    }
    return offset;
  }

  LineColumn next_token(bool is_number) {
    const std::size_t start = skip_between(token_end_);
    token_end_ = static_cast<std::size_t>(farthest_ - text_.data());
    // A number has read one byte too far, unless the text ends with it.
    if (is_number && token_end_ > 0 &&
        std::string_view("0123456789").find(text_[token_end_ - 1]) == std::string_view::npos)
      --token_end_;
    // Counting on from the last token keeps the whole linear.
    const std::string_view passed = text_.substr(counted_to_, start - counted_to_);
    const auto breaks = std::count(passed.begin(), passed.end(), '\n');
    line_ += static_cast<int>(breaks);
    if (breaks > 0) line_start_ = counted_to_ + passed.rfind('\n') + 1;
    counted_to_ = start;
    return {line_, static_cast<int>(start - line_start_) + 1};
  }

  JsonValue& place(JsonValue value) {
    if (open_.empty()) return root_ = std::move(value);
    if (auto* array = std::get_if<JsonValue::Array>(&open_.back()->data))
      return array->emplace_back(std::move(value));
    return std::get<JsonValue::Object>(open_.back()->data)
        .emplace_back(std::move(key_), std::move(value))
        .second;
  }

  template <class T>
  bool add(T&& data, bool is_number = false) {
    const LineColumn at = next_token(is_number);
    place({std::forward<T>(data), &source_, at.line, at.column});
    return true;
  }

  template <class T>
  bool open(T&& data) {
    const LineColumn at = next_token(false);
    if (open_.size() == kDeepest) fail(at, "values are nested deeper than 64 levels");
    open_.push_back(&place({std::forward<T>(data), &source_, at.line, at.column}));
    return true;
  }

  bool close() {
    next_token(false);
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::string& source_;
  const char* const& farthest_;
  JsonValue root_;
  std::vector<JsonValue*> open_;  // a parent holds still while its last child is open
  std::string key_;
  std::size_t token_end_ = 0;
  std::size_t counted_to_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
};

JsonValue parse_value(const std::string& text, const std::string& source) {
  const char* farthest = text.data();
  TreeBuilder builder(text, source, farthest);
  nlohmann::json::sax_parse(CountingIterator(text.data(), &farthest),
                            CountingIterator(text.data() + text.size(), &farthest), &builder,
                            nlohmann::json::input_format_t::json, true, true);
  return builder.take();
}

std::vector<std::string> split_pointer(const Setting& setting) {
  const std::string& pointer = setting.pointer;
  if (pointer.empty() || pointer[0] != '/') {
    throw InputError({.file = "--set"},
                     "a pointer begins with \"/\" (/objects/0/name), got \"" + pointer + "\"");
  }
  std::vector<std::string> parts(1);
  for (std::size_t i = 1; i < pointer.size(); ++i) {
    if (pointer[i] == '/') {
      parts.emplace_back();
    } else if (pointer[i] == '~' && i + 1 < pointer.size() &&
               (pointer[i + 1] == '0' || pointer[i + 1] == '1')) {
      parts.back() += pointer[++i] == '0' ? '~' : '/';
    } else {
      parts.back() += pointer[i];
    }
  }
  return parts;
}

void mark_as_setting(JsonValue& value, const std::string* source) {
  value.source = source;
  value.line = value.column = 0;
  if (auto* array = std::get_if<JsonValue::Array>(&value.data)) {
    for (JsonValue& item : *array) mark_as_setting(item, source);
  } else if (auto* object = std::get_if<JsonValue::Object>(&value.data)) {
    for (auto& [key, member] : *object) mark_as_setting(member, source);
  }
}

}  // namespace

const char* kind_name(const JsonValue& value) {
  static constexpr const char* kNames[] = {"null",     "true or false", "a number",
                                           "a string", "an array",      "an object"};
  return kNames[value.data.index()];
}

JsonDocument parse_json(const std::string& text, const std::string& file) {
  JsonDocument document;
  document.sources.push_back(file);
  document.root = parse_value(text, document.sources.back());
  return document;
}

void apply_setting(JsonDocument& document, const Setting& setting) {
  document.sources.emplace_back("--set");
  const std::string* source = &document.sources.back();
  JsonValue value;
  try {
    value = parse_value(setting.value, *source);
  } catch (const InputError&) {
    value.data = setting.value;  // not JSON: a plain string, so that no shell needs two kinds of quotes
  }
  mark_as_setting(value, source);

  const std::vector<std::string> parts = split_pointer(setting);
  JsonValue* at = &document.root;
  std::string so_far;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_last = i + 1 == parts.size();
    const std::string& part = parts[i];
    const auto fail = [&](const std::string& problem) {
      throw InputError({.file = "--set", .pointer = setting.pointer}, problem);
    };
    if (auto* object = std::get_if<JsonValue::Object>(&at->data)) {
      const auto member = std::find_if(object->begin(), object->end(),
                                       [&](const auto& entry) { return entry.first == part; });
      if (member != object->end()) {
        at = &member->second;
      } else if (is_last) {
        at = &object->emplace_back(part, JsonValue{}).second;
      } else {
        fail("there is no \"" + part + "\" in " + (so_far.empty() ? "the scene" : so_far));
      }
    } else if (auto* array = std::get_if<JsonValue::Array>(&at->data)) {
      if (part == "-" && is_last) {
        at = &array->emplace_back();
      } else {
        const bool is_index =
            !part.empty() && part.size() < 10 && part.find_first_not_of("0123456789") == std::string::npos;
        const std::size_t index = is_index ? std::stoul(part) : array->size();
        if (index >= array->size()) {
          fail(so_far + " has " + std::to_string(array->size()) + " entries, so \"" + part +
               "\" is not among 0 to " + std::to_string(array->empty() ? 0 : array->size() - 1));
        }
        at = &(*array)[index];
      }
    } else {
      fail(so_far + " is " + kind_name(*at) + " and has no \"" + part + "\"");
    }
    so_far += "/" + part;
  }
  *at = std::move(value);
}

}  // namespace sweepkit::scene
