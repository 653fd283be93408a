// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/model.hpp"

namespace sweepkit::report {

/// A scene ready to be drawn with any options.
struct PictureScene {
  scene::Document document;
  scene::Model model;
};

/// Of the document as it stands, its textures for every filter.
PictureScene make_scene(scene::Document document);

/// A square picture of so many pixels a side in place of the scene file's. Throws InputError as it does.
PictureScene read_scene(const std::filesystem::path& file, int side);

/// What these options need, or, where nothing is to be left out, more that leaves the picture as it is.
scene::Plan plan_for(const scene::Document& document, const render::Options& options, bool leaves_out = true);

/// With accelerators built and everything shaded.
render::Picture draw(const PictureScene& scene, const render::Options& options);

/// A byte a pixel, 1 where its middle sees this object first. All 0 where there is no such object.
std::vector<std::uint8_t> mask_of(const PictureScene& scene, const std::string& object);

/// The paper's scene.
inline constexpr const char* kPaperScene = "vase_and_cup";
inline constexpr const char* kPaperFloor = "floor";
inline constexpr const char* kPaperMirror = "left wall";

}  // namespace sweepkit::report
