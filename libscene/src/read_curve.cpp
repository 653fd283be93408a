// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "read_curve.hpp"

namespace sweepkit::scene {
namespace {

template <int D>
std::vector<sweep::Vector<D>> read_points(const Node& node) {
  std::vector<sweep::Vector<D>> points;
  for (const Node& item : node.items()) points.push_back(item.vector<D>(kCoordinate));
  return points;
}

template <int D>
sweep::Curve<D> circle(double radius) {
  if constexpr (D == 2) {
    return sweep::circle_contour(radius);
  } else {
    return sweep::circle_trajectory(radius);
  }
}

template <int D>
sweep::Curve<D> read_kind(const std::string& kind, const Node& node, bool is_closed) {
  if (kind == "bezier") return sweep::bezier_curve<D>(read_points<D>(node));
  if (kind == "beziers") {
    std::vector<std::vector<sweep::Vector<D>>> segments;
    for (const Node& segment : node.items()) {
      segments.push_back(read_points<D>(segment));
      if (segments.back().size() < 2) {
        segment.fail("needs at least 2 control points, got " + std::to_string(segments.back().size()));
      }
    }
    return sweep::joined_bezier_curve<D>(segments);
  }
  if (kind == "free") return sweep::free_curve<D>(read_points<D>(node), is_closed);
  if (kind == "polyline") return sweep::polyline<D>(read_points<D>(node), is_closed);
  if (kind == "line") {
    const std::vector<sweep::Vector<D>> ends = read_points<D>(node);
    if (ends.size() != 2) node.fail("a line needs 2 points, got " + std::to_string(ends.size()));
    return sweep::polyline<D>(ends, false);
  }
  ObjectReader reader(node);
  const double radius = reader.get("radius").number(kExtent);
  reader.finish();
  return circle<D>(radius);
}

template <int D>
sweep::Curve<D> read_curve(const Node& node) {
  static const std::vector<std::string> kKinds = {"bezier", "beziers", "free", "polyline", "line", "circle"};
  ObjectReader reader(node);
  std::optional<Node> chosen;
  std::string kind;
  for (const std::string& name : kKinds) {
    const std::optional<Node> member = reader.find(name);
    if (!member) continue;
    if (chosen) {
      member->fail("a curve is of one kind, but there is \"" + kind + "\" and \"" + name +
                   "\"; leave one out");
    }
    chosen = member;
    kind = name;
  }
  bool is_closed = false;
  if (kind == "free" || kind == "polyline") {
    if (const std::optional<Node> closed = reader.find("closed")) is_closed = closed->boolean();
  }
  reader.finish();
  if (!chosen)
    node.fail("needs one of \"bezier\", \"beziers\", \"free\", \"polyline\", \"line\" or \"circle\"");
  try {
    return read_kind<D>(kind, *chosen, is_closed);
  } catch (const InputError& error) {
    if (!error.place().pointer.empty()) throw;
    chosen->fail(error.problem());  // the curve's own finding, which knows no place
  }
}

}  // namespace

sweep::Curve2 read_contour(const Node& node) {
  return read_curve<2>(node);
}
sweep::Curve3 read_trajectory(const Node& node) {
  return read_curve<3>(node);
}

}  // namespace sweepkit::scene
