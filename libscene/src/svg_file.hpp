// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "outline.hpp"
#include "region.hpp"

namespace sweepkit::scene {

/// One drawn element. Outlines are as drawn, open or closed; what is filled closes its open ones.
struct DrawnShape {
  std::vector<Outline> outlines;
  FillRule rule = FillRule::kNonzero;
  bool is_filled = true;  ///< false: fill="none", and a line element
};

/// A viewer never meets larger drawings, and XML trees take some ten times their text's memory.
inline constexpr std::size_t kLargestSvg = std::size_t{16} << 20;

/// The shapes of an SVG document in the order of drawing, in user units of the outermost viewport (viewBox
/// applied), y upwards: the top left corner is the origin and the drawing lies below it. With an id, that
/// element and what is in it alone, wherever it stands (in defs, a symbol, hidden), as its place in the
/// document transforms it.
///
/// Read: svg, g, a, switch, use, symbol, every basic shape and path; transform, viewBox,
/// preserveAspectRatio; fill-rule, fill="none", display and visibility as attributes or in style. Not drawn:
/// text, images, strokes, markers, clipping and masks. Refused: style sheets that say what is read here, CSS
/// transforms, references to other files.
/// Throws InputError with file, line and column: no XML, no SVG, a bad value, an unknown id, over
/// kMostSegments, nested deeper than 256.
std::vector<DrawnShape> read_svg(const std::string& text, const std::string& file,
                                 const std::optional<std::string>& id);

}  // namespace sweepkit::scene
