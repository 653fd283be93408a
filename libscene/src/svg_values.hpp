// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "outline.hpp"

namespace sweepkit::scene {

/// The values of SVG attributes that have a grammar. Each is read to its end or throws InputError without a
/// place: the offset in bytes from 0, what stands there, and what belongs there.

/// Path data ("M0 0 C..."), drawn by `pen`.
void read_path_data(std::string_view text, OutlineBuilder& pen);

/// A list of transforms: the outer space from the inner one. Whole quarter turns are exact.
glm::dmat3 read_transform(std::string_view text);

/// The points of a polyline or a polygon.
std::vector<glm::dvec2> read_point_list(std::string_view text);

}  // namespace sweepkit::scene
