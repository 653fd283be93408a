// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "json_value.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {

/// The shortest text of a number, for messages.
std::string to_text(double value);

/// "; did you mean \"x\"?" for the most likely of `known`, or "" if none is near.
std::string suggestion(std::string_view given, const std::vector<std::string>& known);

/// What is wrong with a name that is not among `known`: `there is no material "glas"; did you mean ...` or
/// the names there are.
std::string unknown_name(const std::string& kind, std::string_view given,
                         const std::vector<std::string>& known);

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  const char* unit = "";  ///< " m", " degrees"
};
inline constexpr Range kAny{};
/// Beyond it float32 coordinates have steps of 64 m, and squares and products of coordinates could overflow.
inline constexpr double kFarthest = 1e9;
inline constexpr Range kCoordinate{.low = -kFarthest, .high = kFarthest, .unit = " m"};
/// Sizes and factors: from a nanometre on.
inline constexpr Range kExtent{.low = 1e-9, .high = kFarthest, .unit = " m"};
/// Light, as far as float32 and a 16-bit half hold it well.
inline constexpr double kBrightest = 65504;

/// A value on the way of reading, with its pointer. Each reader checks the kind and the range and throws
/// InputError with file, line, column and pointer.
class Node {
 public:
  Node(const JsonValue& value, std::string pointer) : value_(&value), pointer_(std::move(pointer)) {}

  [[noreturn]] void fail(const std::string& problem) const;
  Place place() const;
  const std::string& pointer() const { return pointer_; }
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
  glm::vec3 color(double high = kBrightest) const;

 private:
  const JsonValue* value_;
  std::string pointer_;
};

/// The members of an object. Every key asked for is known; finish() refuses the others.
class ObjectReader {
 public:
  /// Throws InputError unless the node is an object.
  explicit ObjectReader(const Node& node);

  std::optional<Node> find(const std::string& key);
  Node get(const std::string& key);
  /// Every member, where the keys are the user's own names.
  std::vector<std::pair<std::string, Node>> members() const;
  void finish() const;

 private:
  Node member(const JsonMember& of) const;
  [[noreturn]] void refuse(const JsonMember& unknown, const std::vector<std::string>& known) const;

  Node node_;
  const JsonValue::Object* members_;
  std::vector<std::string> known_;
};

}  // namespace sweepkit::scene
