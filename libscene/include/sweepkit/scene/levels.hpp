// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/plan.hpp"

namespace sweepkit::scene {

/// The picture's height that levels of detail are made for, pixels.
inline constexpr double kLevelHeight = 1080;

inline constexpr int kMostLevels = 8;

/// Levels of detail: adds to what build() made of the document at most `levels` coarser meshes of each swept
/// or revolved object, made from the same curves. Level k, from 1 on, is for an object that has at most 2^-k
/// of the picture's height; there its mesh is within a pixel of the surface where the picture is kLevelHeight
/// high: a tolerance of 2^k / kLevelHeight of the diagonal of its box. A level that would save less than a
/// third of the triangles is left out, and so are planes and mesh files. Precondition: levels >= 0, none were
/// added before. Throws InputError as build() does.
void add_levels(Model& model, const Document& document, const Plan& plan, int levels);

}  // namespace sweepkit::scene
