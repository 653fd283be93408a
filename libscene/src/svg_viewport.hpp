// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "svg_element.hpp"

namespace sweepkit::scene {

/// The space inside an element that has a viewport.
struct InnerSpace {
  glm::dmat3 outer_from_inner{1.0};
  Viewport viewport;  ///< of the inside, in its own user units
};

/// The document's own svg element: it stands at its top left corner. A width or a height that it does not
/// give, or gives in percent, follows from the viewBox, one unit being one user unit where both are missing.
InnerSpace outermost_space(const SvgElement& element);

/// A nested svg element or a symbol: placed at its x, y, of its width and height, which are all of the outer
/// viewport unless given. `use` is the element that asks for it, whose width and height go before its own.
InnerSpace nested_space(const SvgElement& element, const Viewport& outer, const SvgElement* use);

}  // namespace sweepkit::scene
