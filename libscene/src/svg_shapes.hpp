// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "outline.hpp"
#include "svg_element.hpp"

namespace sweepkit::scene {

/// path, rect, circle, ellipse, line, polyline, polygon.
bool is_shape(std::string_view kind);

/// Draws a shape in its own user space, from where and in the direction that SVG says. A shape that SVG draws
/// nothing of (a circle of radius 0) leaves nothing.
void draw_shape(const SvgElement& element, const Viewport& viewport, OutlineBuilder& pen);

}  // namespace sweepkit::scene
