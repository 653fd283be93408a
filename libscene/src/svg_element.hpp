// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace sweepkit::scene {

/// What an element needs to say where it stands.
struct SvgSource {
  const std::string& text;
  std::string file;
  bool has_offsets = true;  ///< false where pugixml converted the text to UTF-8
  std::string prefix;       ///< of SVG's own elements, with its colon: "" or "svg:"
};

/// The size of the nearest viewport in user units, where it has one.
using Viewport = std::optional<glm::dvec2>;

/// What a percentage is of.
enum class Along { kWidth, kHeight, kDiagonal };

/// An element of an SVG document. What is wrong with it is told with file, line, column and its tag.
class SvgElement {
 public:
  SvgElement(pugi::xml_node node, const SvgSource& source) : node_(node), source_(&source) {}

  [[noreturn]] void fail(const std::string& problem) const;
  pugi::xml_node node() const { return node_; }
  SvgElement at(pugi::xml_node node) const { return {node, *source_}; }

  /// "path", "g"; "" for what is no element of SVG.
  std::string_view kind() const;
  std::optional<std::string_view> attribute(const char* name) const;
  /// From the style attribute, else the attribute of that name; without blanks about it.
  std::optional<std::string_view> property(std::string_view name) const;

  /// A length in user units. Absolute units as in CSS: 96 px an inch. Nothing where the attribute is missing
  /// or "auto". Throws InputError for units of a font's size, and for a percentage of an unknown viewport.
  std::optional<double> length(const char* name, const Viewport& viewport, Along along) const;
  /// The same, of at least 0.
  std::optional<double> size(const char* name, const Viewport& viewport, Along along) const;

 private:
  pugi::xml_node node_;
  const SvgSource* source_;
};

}  // namespace sweepkit::scene
