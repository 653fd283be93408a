// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "object_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "message_text.hpp"

namespace sweepkit::scene {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substitute, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// A key as a part of a pointer (RFC 6901).
std::string escaped(const std::string& key) {
  std::string out;
  for (const char c : one_line(key)) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

// The first of the names, in quotes.
std::string list_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 16;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    text += (i == 0 ? "" : ", ") + in_quotes(names[i]);
  }
  return names.size() > kMost ? text + ", ..." : text;
}

Place to_place(const JsonPlace& place, const std::string& pointer) {
  return {place.source != nullptr ? *place.source : "", place.line, place.column, pointer};
}

}  // namespace

std::string to_text(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, end);
}

std::string suggestion(std::string_view given, const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 100;  // no misspelling, and the distance takes the product of the lengths
  if (given.size() > kLongest) return "";
  std::size_t best = std::max<std::size_t>(2, given.size() / 3) + 1;
  const std::string* nearest = nullptr;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(given, candidate);
    const bool shares_a_letter = distance < std::max(given.size(), candidate.size());
    if (distance < best && shares_a_letter) {
      best = distance;
      nearest = &candidate;
    }
  }
  return nearest != nullptr ? "; did you mean " + in_quotes(*nearest) + "?" : "";
}

std::string unknown_name(const std::string& kind, std::string_view given,
                         const std::vector<std::string>& known) {
  const std::string text = "there is no " + kind + " " + in_quotes(given);
  const std::string meant = suggestion(given, known);
  if (!meant.empty()) return text + meant;
  if (known.empty()) return text + ": the scene has none";
  return text + "; there is " + list_of(known);
}

void Node::fail(const std::string& problem) const {
  throw InputError(place(), problem);
}

Place Node::place() const {
  return to_place(value_->place, pointer_);
}

double Node::number(const Range& range) const {
  const double* number = std::get_if<double>(&value_->data);
  if (number == nullptr) fail(std::string("needs a number, got ") + kind_name(*value_));
  if (*number < range.low || *number > range.high) {
    std::string limits;
    if (std::isfinite(range.low)) limits = "at least " + to_text(range.low);
    if (std::isfinite(range.high)) {
      limits += (limits.empty() ? "" : " and ") + ("at most " + to_text(range.high));
    }
    fail("needs to be " + limits + range.unit + ", got " + to_text(*number));
  }
  return *number;
}

int Node::integer(int low, int high, const char* unit) const {
  const double value = number({static_cast<double>(low), static_cast<double>(high), unit});
  if (value != std::floor(value)) fail("needs a whole number, got " + to_text(value));
  return static_cast<int>(value);
}

bool Node::boolean() const {
  const bool* value = std::get_if<bool>(&value_->data);
  if (value == nullptr) fail(std::string("needs true or false, got ") + kind_name(*value_));
  return *value;
}

const std::string& Node::text() const {
  const std::string* value = std::get_if<std::string>(&value_->data);
  if (value == nullptr) fail(std::string("needs a string, got ") + kind_name(*value_));
  return *value;
}

std::size_t Node::choice(const std::vector<std::string>& names) const {
  const std::string& given = text();
  const auto found = std::find(names.begin(), names.end(), given);
  if (found == names.end()) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
      list += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + ("\"" + names[i] + "\"");
    }
    fail("needs " + list + ", got " + in_quotes(given));
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<Node> Node::items() const {
  const auto* array = std::get_if<JsonValue::Array>(&value_->data);
  if (array == nullptr) fail(std::string("needs an array, got ") + kind_name(*value_));
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < array->size(); ++i)
    nodes.emplace_back((*array)[i], pointer_ + "/" + std::to_string(i));
  return nodes;
}

template <int D>
glm::vec<D, double> Node::vector(const Range& range) const {
  const auto* array = std::get_if<JsonValue::Array>(&value_->data);
  if (array == nullptr)
    fail("needs " + std::to_string(D) + " numbers in an array, got " + kind_name(*value_));
  if (array->size() != D)
    fail("needs " + std::to_string(D) + " numbers, got " + std::to_string(array->size()));
  glm::vec<D, double> result(0.0);
  for (int i = 0; i < D; ++i) {
    const JsonValue& item = (*array)[static_cast<std::size_t>(i)];
    const double* number = std::get_if<double>(&item.data);
    const bool is_sound = number != nullptr && *number >= range.low && *number <= range.high;
    // The slow way tells what is wrong, and where.
    result[i] = is_sound ? *number : Node(item, pointer_ + "/" + std::to_string(i)).number(range);
  }
  return result;
}

glm::vec3 Node::color(double high) const {
  return glm::vec3(vector<3>({.low = 0, .high = high}));
}

ObjectReader::ObjectReader(const Node& node)
    : node_(node), members_(std::get_if<JsonValue::Object>(&node.value().data)) {
  if (members_ == nullptr) node.fail(std::string("needs an object, got ") + kind_name(node.value()));
}

Node ObjectReader::member(const JsonMember& of) const {
  return {of.value, node_.pointer() + "/" + escaped(of.key)};
}

void ObjectReader::refuse(const JsonMember& unknown, const std::vector<std::string>& known) const {
  const std::string meant = suggestion(unknown.key, known);
  throw InputError(
      to_place(unknown.key_place, member(unknown).pointer()),
      "unknown key " + in_quotes(unknown.key) + (meant.empty() ? "; there is " + list_of(known) : meant));
}

std::optional<Node> ObjectReader::find(const std::string& key) {
  known_.push_back(key);
  for (const JsonMember& candidate : *members_) {
    if (candidate.key == key) return member(candidate);
  }
  return std::nullopt;
}

Node ObjectReader::get(const std::string& key) {
  const std::optional<Node> found = find(key);
  if (found) return *found;
  // A misspelt key is more likely than a forgotten one.
  for (const JsonMember& other : *members_) {
    const bool is_known = std::find(known_.begin(), known_.end(), other.key) != known_.end();
    if (!is_known && !suggestion(other.key, {key}).empty()) refuse(other, {key});
  }
  node_.fail("needs " + in_quotes(key));
}

std::vector<std::pair<std::string, Node>> ObjectReader::members() const {
  std::vector<std::pair<std::string, Node>> all;
  for (const JsonMember& each : *members_) all.emplace_back(each.key, member(each));
  return all;
}

void ObjectReader::finish() const {
  for (const JsonMember& each : *members_) {
    if (std::find(known_.begin(), known_.end(), each.key) == known_.end()) refuse(each, known_);
  }
}

template glm::vec<2, double> Node::vector<2>(const Range&) const;
template glm::vec<3, double> Node::vector<3>(const Range&) const;

}  // namespace sweepkit::scene
