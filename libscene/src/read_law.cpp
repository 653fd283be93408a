// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "read_law.hpp"

namespace sweepkit::scene {
namespace {

constexpr Range kSize{.low = 0, .high = kFarthest};
constexpr Range kTurn{.low = -1e9, .high = 1e9, .unit = " degrees"};

std::vector<glm::dvec2> read_points(const Node& node, const Range& range) {
  std::vector<glm::dvec2> points;
  for (const Node& item : node.items()) {
    const std::vector<Node> pair = item.items();
    if (pair.size() != 2)
      item.fail("needs 2 numbers, t and the value there, got " + std::to_string(pair.size()));
    points.emplace_back(pair[0].number({.low = 0, .high = 1}), pair[1].number(range));
  }
  return points;
}

}  // namespace

sweep::Law read_law(const Node& node, const Range& range) {
  if (node.is_number()) return node.number(range);
  if (!node.is_object()) node.fail("needs a number or an object with \"points\" or \"bezier\"");
  ObjectReader reader(node);
  const std::optional<Node> points = reader.find("points");
  const std::optional<Node> bezier = reader.find("bezier");
  reader.finish();
  if (points.has_value() == bezier.has_value()) {
    node.fail("needs a number, \"points\" or \"bezier\", one of them");
  }
  const Node& given = points ? *points : *bezier;
  const std::vector<glm::dvec2> values = read_points(given, range);
  try {
    return points ? sweep::Law::through(values) : sweep::Law::bezier(values);
  } catch (const InputError& error) {
    given.fail(error.problem());  // the law's own finding, which knows no place
  }
}

sweep::Profile read_profile(const Node& node) {
  if (node.is_object()) {
    ObjectReader reader(node);
    const std::optional<Node> x = reader.find("x");
    const std::optional<Node> y = reader.find("y");
    if (x || y) {
      reader.finish();
      return {x ? read_law(*x, kSize) : sweep::Law(1), y ? read_law(*y, kSize) : sweep::Law(1)};
    }
  }
  const sweep::Law both = read_law(node, kSize);
  return {both, both};
}

sweep::Law read_twist(const Node& node) {
  if (!node.is_number()) return read_law(node, kTurn);
  return sweep::Law::through({{0, 0}, {1, node.number(kTurn)}});
}

}  // namespace sweepkit::scene
