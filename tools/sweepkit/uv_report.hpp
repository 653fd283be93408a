// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output.hpp"
#include "report.hpp"
#include "scene_input.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::tools {

/// `info --uv`: for each object how its texture lies on it in the world - homogeneity of resolution, aspect
/// ratio, density, seams, overlaps, and triangles without texture or with a mirrored one.
Table uv_table(const scene::Scene& scene);

/// The same report's second table: how far each of the triangle maps of the paper's section 2 puts the
/// centroids of an object's triangles from the texture's, in legs.
Table centroid_table(const scene::Scene& scene);

enum class HeatMeasure { kAspectRatio, kHomogeneity };

struct HeatMapRequest {
  std::string file;  ///< empty: none is wanted
  PixelSize size{1024, 1024};
  HeatMeasure measure = HeatMeasure::kAspectRatio;
};

/// Draws the measure of the scene's only object over its texture and writes the image, whole or not at all;
/// says in a line what the colours mean. Throws InputError for a name that is no image's, OutputError for the
/// disk.
void write_heat_map(const scene::Scene& scene, const HeatMapRequest& request, const Output& output);

}  // namespace sweepkit::tools
