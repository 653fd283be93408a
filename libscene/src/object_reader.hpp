// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "json_value.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {

/// The shortest text of a number, for messages.
std::string to_text(double value);

/// "; did you mean \"x\"?" for the most likely of `known`, or "" if none is near.
std::string suggestion(std::string_view given, const std::vector<std::string>& known);

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  const char* unit = "";  ///< " m", " degrees"
  bool excludes_low = false;
  bool excludes_high = false;
};
inline constexpr Range kAny{};

/// A value on the way of reading, with its pointer. Each reader checks the kind and the range and throws
/// InputError with file, line, column and pointer.
class Node {
 public:
  Node(const JsonValue& value, std::string pointer) : value_(&value), pointer_(std::move(pointer)) {}

  [[noreturn]] void fail(const std::string& problem) const;
  Place place() const;
  const JsonValue& value() const { return *value_; }
  bool is_array() const { return std::holds_alternative<JsonValue::Array>(value_->data); }
  bool is_object() const { return std::holds_alternative<JsonValue::Object>(value_->data); }
  bool is_number() const { return std::holds_alternative<double>(value_->data); }

  double number(const Range& range = kAny) const;
  int integer(int low, int high, const char* unit = "") const;
  bool boolean() const;
  const std::string& text() const;
  /// One of the names; its index.
  std::size_t choice(const std::vector<std::string>& names) const;
  std::vector<Node> items() const;
  /// Exactly D numbers.
  template <int D>
  glm::vec<D, double> vector(const Range& range = kAny) const;
  glm::vec3 color(double high = std::numeric_limits<double>::infinity()) const;

 private:
  const JsonValue* value_;
  std::string pointer_;
};

/// The members of an object. Every key asked for is known; finish() refuses the others.
class ObjectReader {
 public:
  explicit ObjectReader(const Node& node, std::string pointer);

  std::optional<Node> find(const std::string& key);
  Node get(const std::string& key);
  const Node& node() const { return node_; }
  void finish() const;

 private:
  Node node_;
  std::string pointer_;
  std::vector<std::string> known_;
};

ObjectReader read_object(const Node& node);

}  // namespace sweepkit::scene
