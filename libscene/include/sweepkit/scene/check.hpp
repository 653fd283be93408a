// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/sweep/finding.hpp"

namespace sweepkit::scene {

/// A finding about one of the scene's shapes, its point in the world.
struct SceneFinding {
  std::string object;
  Place place;             ///< of the shape in the scene file
  sweep::Finding finding;  ///< of instances, in the first
};

enum class Thoroughness {
  kQuick,  ///< crossings of a large mesh are looked for in a coarser one of the same curves
  kWhole,
};

/// What sweep::check_sweep(), check_revolve() and find_crossings() find of every shape of a built scene, in
/// the objects' order; of mesh files crossings alone, without t, and none by a quick look at a large one. A
/// crossing where the surface folds anyway is left out. Shapes of one object may go
/// through each other. Throws InputError with the shape's place.
std::vector<SceneFinding> check(const Document& document, const Model& model,
                                Thoroughness thoroughness = Thoroughness::kWhole);

/// A material that gives back more light than falls on it: what it scatters, mirrors and transmits comes to
/// more than 1. With Fresnel's shares only the larger of mirrored and transmitted counts.
struct MaterialFinding {
  std::string material;
  Place place;
  double sum;
  std::string problem;  ///< "diffuse 0.9, reflect 0.2 and transmit 0 come to 1.1"
  std::string cure;     ///< "0.909 times each of them fits"
};
std::vector<MaterialFinding> check_materials(const Document& document);

}  // namespace sweepkit::scene
