// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "read_curve.hpp"

#include <algorithm>

#include "message_text.hpp"
#include "read_curve_file.hpp"
#include "sweepkit/sweep/primitives.hpp"

namespace sweepkit::scene {
namespace {

template <int D>
std::vector<sweep::Vector<D>> read_points(const Node& node) {
  std::vector<sweep::Vector<D>> points;
  for (const Node& item : node.items()) points.push_back(item.vector<D>(kCoordinate));
  return points;
}

constexpr Range kAngle{.low = -1e9, .high = 1e9, .unit = " degrees"};

// A plane primitive; nothing if `kind` is none. As a trajectory it lies in the x,z plane.
std::optional<sweep::Curve2> read_plane_primitive(const std::string& kind, ObjectReader& reader) {
  const auto size = [&](const char* key) { return reader.get(key).number(kExtent); };
  const auto angle = [&](const char* key) { return reader.get(key).number(kAngle); };
  if (kind == "circle") return sweep::circle_contour(size("radius"));
  if (kind == "ellipse") return sweep::ellipse_contour(size("rx"), size("ry"));
  if (kind == "rectangle") {
    const std::optional<Node> corner = reader.find("corner_radius");
    return sweep::rectangle_contour(size("width"), size("height"), corner ? corner->number() : 0);
  }
  if (kind == "polygon") {
    return sweep::polygon_contour(reader.get("sides").integer(3, 4096), size("radius"));
  }
  if (kind == "star") {
    return sweep::star_contour(reader.get("points").integer(2, 2048), size("radius"), size("inner_radius"));
  }
  if (kind == "arc") return sweep::arc_contour(size("radius"), angle("from_deg"), angle("to_deg"));
  return std::nullopt;
}

sweep::Curve3 read_space_primitive(const std::string& kind, ObjectReader& reader) {
  const auto size = [&](const char* key) { return reader.get(key).number(kExtent); };
  if (kind == "helix") {
    return sweep::helix(size("radius"), reader.get("pitch").number(kCoordinate),
                        reader.get("turns").number({.low = 1e-9, .high = 1e6}));
  }
  return sweep::torus_knot(reader.get("p").integer(1, 1000), reader.get("q").integer(1, 1000), size("radius"),
                           size("tube"));
}

template <int D>
sweep::Curve<D> read_primitive(const std::string& kind, const Node& node) {
  ObjectReader reader(node);
  if constexpr (D == 2) {
    sweep::Curve2 curve = *read_plane_primitive(kind, reader);
    reader.finish();
    return curve;
  } else {
    const std::optional<sweep::Curve2> plane = read_plane_primitive(kind, reader);
    sweep::Curve3 curve = plane ? sweep::laid_flat(*plane) : read_space_primitive(kind, reader);
    reader.finish();
    return curve;
  }
}

// What may stand beside a curve's kind.
struct Beside {
  bool is_closed = false;
  bool is_smooth = false;
  double scale = 1;
  std::optional<std::string> id;
};

Beside read_beside(const std::string& kind, ObjectReader& reader) {
  const auto is_one_of = [&](std::initializer_list<const char*> kinds) {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  };
  Beside beside;
  if (is_one_of({"free", "polyline", "csv"})) {
    if (const std::optional<Node> closed = reader.find("closed")) beside.is_closed = closed->boolean();
  }
  if (is_one_of({"csv"})) {
    if (const std::optional<Node> smooth = reader.find("smooth")) beside.is_smooth = smooth->boolean();
  }
  if (is_one_of({"svg", "path"})) {
    if (const std::optional<Node> scale = reader.find("scale")) {
      beside.scale = scale->number({.low = 1e-9, .high = 1e9});
    }
  }
  if (is_one_of({"svg"})) {
    if (const std::optional<Node> id = reader.find("id")) beside.id = id->text();
  }
  return beside;
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
  return read_primitive<D>(kind, node);
}

// Several outlines of the kinds that files bring, one of the others.
template <int D>
using Read = std::conditional_t<D == 2, std::vector<sweep::Curve2>, sweep::Curve3>;

template <int D, class Given>
Read<D> read_given(const Given& given) {
  if constexpr (D == 2) {
    return contour_of(given);
  } else {
    return trajectory_of(given);
  }
}

template <int D>
Read<D> read_any(const std::string& kind, const Node& node, const Beside& beside,
                 const std::filesystem::path& folder) {
  if (kind == "path") return read_given<D>(PathCurve{node.text(), beside.scale});
  if (kind == "svg" || kind == "csv") {
    if (node.text().empty()) node.fail("needs a file's name, got \"\"");
    const std::filesystem::path file = folder / node.text();
    if (kind == "svg") return read_given<D>(SvgCurve{file, beside.id, beside.scale});
    return read_given<D>(PointCurve{file, beside.is_closed, beside.is_smooth});
  }
  return {read_kind<D>(kind, node, beside.is_closed)};
}

// The kinds of curve there are; helix and torus knot are no plane ones.
template <int D>
std::vector<std::string> kinds() {
  std::vector<std::string> kinds = {"bezier", "beziers", "free",    "polyline",  "line",    "svg",  "path",
                                    "csv",    "circle",  "ellipse", "rectangle", "polygon", "star", "arc"};
  if (D == 3) kinds.insert(kinds.end(), {"helix", "torus_knot"});
  return kinds;
}

template <int D>
Read<D> read_curve(const Node& node, const std::filesystem::path& folder) {
  static const std::vector<std::string> kKinds = kinds<D>();
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
  const Beside beside = read_beside(kind, reader);
  reader.finish();
  if (!chosen) {
    std::string names;
    for (const std::string& name : kKinds) names += (names.empty() ? "" : ", ") + in_quotes(name);
    node.fail("needs one of " + names);
  }
  try {
    return read_any<D>(kind, *chosen, beside, folder);
  } catch (const InputError& error) {
    if (!error.place().pointer.empty()) throw;
    chosen->fail(error.what());  // the curve's own finding, which knows no place but in its own file
  }
}

}  // namespace

std::vector<sweep::Curve2> read_contour(const Node& node, const std::filesystem::path& folder) {
  return read_curve<2>(node, folder);
}
sweep::Curve3 read_trajectory(const Node& node, const std::filesystem::path& folder) {
  return read_curve<3>(node, folder);
}

}  // namespace sweepkit::scene
