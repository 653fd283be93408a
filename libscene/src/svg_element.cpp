// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "svg_element.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "message_text.hpp"
#include "number_token.hpp"
#include "object_reader.hpp"
#include "text_file.hpp"

namespace sweepkit::scene {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n\f";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// The last declaration of a property in a style attribute counts.
std::optional<std::string_view> declared(std::string_view style, std::string_view name) {
  std::optional<std::string_view> value;
  while (!style.empty()) {
    const std::string_view declaration = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(declaration.size() + 1, style.size()));
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos || trimmed(declaration.substr(0, colon)) != name) continue;
    const std::string_view given = declaration.substr(colon + 1);
    value = trimmed(given.substr(0, given.find('!')));  // without "!important"
  }
  return value;
}

constexpr std::array<std::pair<std::string_view, double>, 9> kUnits = {{{"", 1},
                                                                        {"px", 1},
                                                                        {"in", 96},
                                                                        {"cm", 96 / 2.54},
                                                                        {"mm", 96 / 25.4},
                                                                        {"Q", 96 / 101.6},
                                                                        {"pt", 96.0 / 72},
                                                                        {"pc", 16},
                                                                        {"%", 0}}};

}  // namespace

void SvgElement::fail(const std::string& problem) const {
  const Place place =
      source_->has_offsets && node_.offset_debug() > 0
          ? place_in(source_->text, static_cast<std::size_t>(node_.offset_debug()) - 1, source_->file)
          : Place{.file = source_->file};
  const pugi::xml_attribute id = node_.attribute("id");
  throw InputError(place, '<' + one_line(node_.name(), 40) +
                              (id ? " id=" + in_quotes(id.value()) : std::string()) + ">: " + problem);
}

std::string_view SvgElement::kind() const {
  std::string_view name = node_.name();
  if (node_.type() != pugi::node_element || !name.starts_with(source_->prefix)) return {};
  name.remove_prefix(source_->prefix.size());
  return name.find(':') == std::string_view::npos ? name : std::string_view();
}

std::optional<std::string_view> SvgElement::attribute(const char* name) const {
  const pugi::xml_attribute found = node_.attribute(name);
  if (!found) return std::nullopt;
  return trimmed(found.value());
}

std::optional<std::string_view> SvgElement::property(std::string_view name) const {
  if (const auto style = attribute("style")) {
    if (const auto value = declared(*style, name)) return value;
  }
  return attribute(std::string(name).c_str());
}

std::optional<double> SvgElement::length(const char* name, const Viewport& viewport, Along along) const {
  const std::optional<std::string_view> given = attribute(name);
  if (!given || *given == "auto") return std::nullopt;
  std::string_view unit = *given;
  const std::optional<double> number = take_number(unit);
  const auto refuse = [&](const std::string& why) {
    fail(in_quotes(name) + why + ", got " + in_quotes(*given));
  };
  if (!number) refuse(" needs a length");
  if (!std::isfinite(*number)) refuse(" is too large");
  for (const auto& [known, user_units] : kUnits) {
    if (unit != known) continue;
    if (unit != "%") return *number * user_units;
    if (!viewport) refuse(" is a share of a size the svg element does not have; give it a viewBox");
    const glm::dvec2 whole = *viewport;
    const double of = along == Along::kWidth    ? whole.x
                      : along == Along::kHeight ? whole.y
                                                : glm::length(whole) / std::sqrt(2.0);
    return *number / 100 * of;
  }
  refuse(" needs a length in px, in, cm, mm, Q, pt, pc or %");
  return std::nullopt;
}

std::optional<double> SvgElement::size(const char* name, const Viewport& viewport, Along along) const {
  const std::optional<double> value = length(name, viewport, along);
  if (value && *value < 0) fail(in_quotes(name) + " needs to be at least 0, got " + to_text(*value));
  return value;
}

}  // namespace sweepkit::scene
