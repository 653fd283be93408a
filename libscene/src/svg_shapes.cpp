// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on SVG 2, chapter 10 "Basic shapes", each with its equivalent path.
#include "svg_shapes.hpp"

#include <algorithm>
#include <array>

#include "message_text.hpp"
#include "svg_values.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

// Reads an attribute's text; what is wrong with it names the attribute.
template <class Read>
auto reading(const SvgElement& element, const char* name, const Read& read) {
  try {
    return read(element.attribute(name).value_or(""));
  } catch (const InputError& error) {
    element.fail(in_quotes(name) + " " + error.problem());
  }
}

glm::dvec2 point(const SvgElement& element, const Viewport& viewport, const char* x, const char* y) {
  return {element.length(x, viewport, Along::kWidth).value_or(0),
          element.length(y, viewport, Along::kHeight).value_or(0)};
}

// rx and ry; one that is missing is as the other.
std::optional<glm::dvec2> radii(const SvgElement& element, const Viewport& viewport) {
  const std::optional<double> rx = element.size("rx", viewport, Along::kWidth);
  const std::optional<double> ry = element.size("ry", viewport, Along::kHeight);
  if (!rx && !ry) return std::nullopt;
  return glm::dvec2(rx ? *rx : *ry, ry ? *ry : *rx);
}

void draw_rect(const SvgElement& element, const Viewport& viewport, OutlineBuilder& pen) {
  const glm::dvec2 low = point(element, viewport, "x", "y");
  const glm::dvec2 size(element.size("width", viewport, Along::kWidth).value_or(0),
                        element.size("height", viewport, Along::kHeight).value_or(0));
  if (!(size.x > 0 && size.y > 0)) return;
  const glm::dvec2 high = low + size;
  const glm::dvec2 r = glm::min(radii(element, viewport).value_or(glm::dvec2(0)), 0.5 * size);
  const bool is_round = r.x > 0 && r.y > 0;
  const auto corner = [&](const glm::dvec2& from, const glm::dvec2& to) {
    pen.line_to(from);
    if (is_round) pen.arc_to({r, 0, false, true}, to);
  };
  const glm::dvec2 in = is_round ? r : glm::dvec2(0);
  pen.move_to({low.x + in.x, low.y});
  corner({high.x - in.x, low.y}, {high.x, low.y + in.y});
  corner({high.x, high.y - in.y}, {high.x - in.x, high.y});
  corner({low.x + in.x, high.y}, {low.x, high.y - in.y});
  corner({low.x, low.y + in.y}, {low.x + in.x, low.y});
  pen.close_subpath();
}

void draw_circle(const SvgElement& element, const Viewport& viewport, OutlineBuilder& pen) {
  const double r = element.size("r", viewport, Along::kDiagonal).value_or(0);
  if (r > 0) pen.ellipse(point(element, viewport, "cx", "cy"), glm::dvec2(r));
}

void draw_ellipse(const SvgElement& element, const Viewport& viewport, OutlineBuilder& pen) {
  const glm::dvec2 r = radii(element, viewport).value_or(glm::dvec2(0));
  if (r.x > 0 && r.y > 0) pen.ellipse(point(element, viewport, "cx", "cy"), r);
}

void draw_line(const SvgElement& element, const Viewport& viewport, OutlineBuilder& pen) {
  pen.move_to(point(element, viewport, "x1", "y1"));
  pen.line_to(point(element, viewport, "x2", "y2"));
}

void draw_points(const SvgElement& element, OutlineBuilder& pen) {
  const std::vector<glm::dvec2> points = reading(element, "points", read_point_list);
  if (points.empty()) return;
  pen.move_to(points.front());
  for (const glm::dvec2& to : points) pen.line_to(to);
  if (element.kind() == "polygon") pen.close_subpath();
}

void draw(const SvgElement& element, const Viewport& viewport, OutlineBuilder& pen) {
  const std::string_view kind = element.kind();
  if (kind == "path") {
    if (element.attribute("d") == "none") return;
    reading(element, "d", [&](std::string_view data) { read_path_data(data, pen); });
  }
  if (kind == "rect") draw_rect(element, viewport, pen);
  if (kind == "circle") draw_circle(element, viewport, pen);
  if (kind == "ellipse") draw_ellipse(element, viewport, pen);
  if (kind == "line") draw_line(element, viewport, pen);
  if (kind == "polyline" || kind == "polygon") draw_points(element, pen);
}

constexpr std::array<std::string_view, 7> kShapes = {"path", "rect",     "circle", "ellipse",
                                                     "line", "polyline", "polygon"};

}  // namespace

bool is_shape(std::string_view kind) {
  return std::find(kShapes.begin(), kShapes.end(), kind) != kShapes.end();
}

void draw_shape(const SvgElement& element, const Viewport& viewport, OutlineBuilder& pen) {
  try {
    draw(element, viewport, pen);
  } catch (const InputError& error) {
    if (!error.place().file.empty()) throw;
    element.fail(error.problem());  // the pen's, which knows no element
  }
}

}  // namespace sweepkit::scene
