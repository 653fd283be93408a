// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on SVG 2, 8.2 "Computing the equivalent transform of an SVG viewport". What reaches beyond a viewport
// is not cut off.
#include "svg_viewport.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "message_text.hpp"
#include "number_token.hpp"

namespace sweepkit::scene {
namespace {

struct ViewBox {
  glm::dvec2 corner;
  glm::dvec2 size;
};

std::optional<ViewBox> view_box(const SvgElement& element) {
  const std::optional<std::string_view> given = element.attribute("viewBox");
  if (!given) return std::nullopt;
  constexpr std::string_view kBetween = " \t\r\n\f,";
  std::array<double, 4> numbers{};
  std::string_view rest = *given;
  for (double& number : numbers) {
    const std::optional<double> read = take_number(rest);
    if (!read || !std::isfinite(*read)) element.fail("\"viewBox\" needs 4 numbers, got " + in_quotes(*given));
    number = *read;
    rest.remove_prefix(std::min(rest.find_first_not_of(kBetween), rest.size()));
  }
  if (!rest.empty()) element.fail("\"viewBox\" needs 4 numbers, got " + in_quotes(*given));
  if (!(numbers[2] > 0 && numbers[3] > 0)) {
    element.fail("\"viewBox\" needs a width and a height above 0, got " + in_quotes(*given));
  }
  return ViewBox{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

// Where a viewBox lies in a viewport of another shape.
struct Fit {
  bool is_stretched = false;
  glm::dvec2 align{0.5};  ///< the share of the room left over that is before it
  bool is_covering = false;
};

Fit fit_of(const SvgElement& element) {
  std::string_view given = element.attribute("preserveAspectRatio").value_or("");
  const std::string_view all = given;
  Fit fit;
  const auto word = [&] {
    const std::string_view next = given.substr(0, given.find_first_of(" \t\r\n\f"));
    given.remove_prefix(next.size());
    given.remove_prefix(std::min(given.find_first_not_of(" \t\r\n\f"), given.size()));
    return next;
  };
  const auto share = [&](std::string_view name) {
    if (name == "Min") return 0.0;
    if (name == "Mid") return 0.5;
    if (name == "Max") return 1.0;
    element.fail("\"preserveAspectRatio\" needs none or a value as xMidYMid, then meet or slice, got " +
                 in_quotes(all));
  };
  if (given.empty()) return fit;
  const std::string_view align = word();
  if (align == "none") {
    fit.is_stretched = true;
  } else {
    const bool is_whole = align.size() == 8 && align[0] == 'x' && align[4] == 'Y';
    fit.align = {share(is_whole ? align.substr(1, 3) : ""), share(is_whole ? align.substr(5) : "")};
  }
  const std::string_view meet = word();
  if (!(meet.empty() || meet == "meet" || meet == "slice") || !given.empty()) share("");
  fit.is_covering = meet == "slice";
  return fit;
}

InnerSpace inner_space(const SvgElement& element, const glm::dvec2& corner, const Viewport& size,
                       const std::optional<ViewBox>& box) {
  InnerSpace inner{.viewport = size};
  glm::dvec2 scale(1);
  glm::dvec2 origin = corner;
  if (box && size) {
    inner.viewport = box->size;
    scale = *size / box->size;
    const Fit fit = fit_of(element);
    if (!fit.is_stretched) {
      scale = glm::dvec2(fit.is_covering ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y));
    }
    origin += fit.align * (*size - scale * box->size) - scale * box->corner;
  }
  inner.outer_from_inner = {{scale.x, 0, 0}, {0, scale.y, 0}, {origin.x, origin.y, 1}};
  return inner;
}

void check_size(const SvgElement& element, const Viewport& size) {
  if (size && !(size->x > 0 && size->y > 0)) {
    element.fail("is drawn by no viewer: its width or height is 0; give them above 0, or a viewBox alone");
  }
}

}  // namespace

InnerSpace outermost_space(const SvgElement& element) {
  const auto absolute = [&](const char* name) -> std::optional<double> {
    const std::string_view given = element.attribute(name).value_or("auto");
    if (given.ends_with('%')) return std::nullopt;
    return element.size(name, std::nullopt, Along::kDiagonal);
  };
  const std::optional<ViewBox> box = view_box(element);
  std::optional<double> width = absolute("width");
  std::optional<double> height = absolute("height");
  if (box) {
    const bool has_neither = !width && !height;
    if (!width) width = has_neither ? box->size.x : *height * (box->size.x / box->size.y);
    if (!height) height = has_neither ? box->size.y : *width * (box->size.y / box->size.x);
  }
  Viewport size;
  if (width && height) size = glm::dvec2(*width, *height);
  check_size(element, size);
  return inner_space(element, glm::dvec2(0), size, box);
}

InnerSpace nested_space(const SvgElement& element, const Viewport& outer, const SvgElement* use) {
  const auto extent = [&](const char* name, Along along) -> std::optional<double> {
    if (use != nullptr) {
      if (const auto asked = use->size(name, outer, along)) return asked;
    }
    if (const auto own = element.size(name, outer, along)) return own;
    if (!outer) return std::nullopt;
    return along == Along::kWidth ? outer->x : outer->y;
  };
  const glm::dvec2 corner(element.length("x", outer, Along::kWidth).value_or(0),
                          element.length("y", outer, Along::kHeight).value_or(0));
  const std::optional<double> width = extent("width", Along::kWidth);
  const std::optional<double> height = extent("height", Along::kHeight);
  const std::optional<ViewBox> box = view_box(element);
  Viewport size;
  if (width && height) size = glm::dvec2(*width, *height);
  if (box && !size) element.fail("needs \"width\" and \"height\": the svg element about it has no size");
  check_size(element, size);
  return inner_space(element, corner, size, box);
}

}  // namespace sweepkit::scene
