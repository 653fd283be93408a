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
#include <unordered_set>

#include "json_value.hpp"
#include "message_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kDeepest = 64;

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
    key_place_ = next_token(false);
    if (!open_.back().keys.insert(name).second) {
      fail(key_place_, in_quotes(name) + " stands twice in this object; leave one out");
    }
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception& error) override {
    const std::string what = error.what();
    // A wrong comma or bracket stands where the lexer is; any other token began further left.
    const std::size_t last = std::min(position > 0 ? position - 1 : 0, text_.size());
    const bool is_mark = what.find(" unexpected ") != std::string::npos && last < text_.size() &&
                         std::string_view(",:{}[]").find(text_[last]) != std::string_view::npos;
    const JsonPlace at = is_mark ? place_of(last) : next_token(true);
    constexpr std::string_view kOverflow = "number overflow parsing ";
    if (const std::size_t found = what.find(kOverflow); found != std::string::npos) {
      fail(at, "the number " + one_line(what.substr(found + kOverflow.size()), 80) + " is too large");
    }
    fail(at, "not valid JSON: " + finding(what));
  }

 private:
  struct Open {
    JsonValue* value;  // holds still: a parent gets no other child before this one is closed
    std::unordered_set<std::string> keys;
  };

  [[noreturn]] void fail(const JsonPlace& at, std::string problem) const {
    throw InputError({.file = source_, .line = at.line, .column = at.column}, std::move(problem));
  }

  // nlohmann's "[...] parse error at line 1, column 2: syntax error while parsing value - unexpected ']';
  // last read: ...; expected ..." without what the place says already, and without the text read, which may
  // be no UTF-8.
  static std::string finding(const std::string& what) {
    const std::size_t start = what.find("while parsing ");
    std::string text = start == std::string::npos ? what : what.substr(start);
    if (const std::size_t read = text.find("; last read: "); read != std::string::npos) {
      const std::size_t expected = text.rfind("; expected ");
      const bool has_more = expected != std::string::npos && expected > read;
      text = text.substr(0, read) + (has_more ? text.substr(expected) : "");
    }
    return one_line(text);
  }

  std::size_t skip_between(std::size_t offset) const {
    while (offset < text_.size()) {
      const char c = text_[offset];
      if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ':' || c == '\xEF' ||
          c == '\xBB' || c == '\xBF') {
        ++offset;
      } else if (c == '/' && offset + 1 < text_.size() &&
                 (text_[offset + 1] == '/' || text_[offset + 1] == '*')) {
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

  // Counting on from the last place keeps the whole linear.
  JsonPlace place_of(std::size_t offset) {
    const std::string_view passed = text_.substr(counted_to_, offset - counted_to_);
    const auto breaks = std::count(passed.begin(), passed.end(), '\n');
    line_ += static_cast<int>(breaks);
    if (breaks > 0) line_start_ = counted_to_ + passed.rfind('\n') + 1;
    counted_to_ = offset;
    return {&source_, line_, static_cast<int>(offset - line_start_) + 1};
  }

  JsonPlace next_token(bool is_number) {
    const std::size_t start = skip_between(token_end_);
    token_end_ = static_cast<std::size_t>(farthest_ - text_.data());
    // A number has read one byte too far, unless the text ends with it.
    if (is_number && token_end_ > 0 &&
        std::string_view("0123456789").find(text_[token_end_ - 1]) == std::string_view::npos) {
      --token_end_;
    }
    return place_of(start);
  }

  JsonValue& put(JsonValue value) {
    if (open_.empty()) return root_ = std::move(value);
    if (auto* array = std::get_if<JsonValue::Array>(&open_.back().value->data)) {
      return array->emplace_back(std::move(value));
    }
    auto& object = std::get<JsonValue::Object>(open_.back().value->data);
    return object.emplace_back(JsonMember{std::move(key_), key_place_, std::move(value)}).value;
  }

  template <class T>
  bool add(T&& data, bool is_number = false) {
    put({std::forward<T>(data), next_token(is_number)});
    return true;
  }

  template <class T>
  bool open(T&& data) {
    const JsonPlace at = next_token(false);
    if (open_.size() == kDeepest) fail(at, "values are nested deeper than 64 levels; the scene needs fewer");
    open_.push_back({&put({std::forward<T>(data), at}), {}});
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
  std::vector<Open> open_;
  std::string key_;
  JsonPlace key_place_;
  std::size_t token_end_ = 0;
  std::size_t counted_to_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
};

}  // namespace

const char* kind_name(const JsonValue& value) {
  static constexpr const char* kNames[] = {"null",     "true or false", "a number",
                                           "a string", "an array",      "an object"};
  return kNames[value.data.index()];
}

JsonValue parse_json_value(const std::string& text, const std::string& source) {
  const char* farthest = text.data();
  TreeBuilder builder(text, source, farthest);
  nlohmann::json::sax_parse(CountingIterator(text.data(), &farthest),
                            CountingIterator(text.data() + text.size(), &farthest), &builder,
                            nlohmann::json::input_format_t::json, true, true);
  return builder.take();
}

JsonDocument parse_json(const std::string& text, const std::string& file) {
  JsonDocument document;
  document.sources.push_back(file);
  document.root = parse_json_value(text, document.sources.back());
  return document;
}

}  // namespace sweepkit::scene
