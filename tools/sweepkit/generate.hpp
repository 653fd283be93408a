// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "output.hpp"
#include "scene_input.hpp"
#include "sweepkit/scene/check.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/plan.hpp"

namespace CLI {
class App;
}

namespace sweepkit::tools {

/// What `generate` was asked for.
struct Generate {
  SceneInput input;
  Output output;
  std::string object;  ///< this one alone; empty: all
  std::string values;  ///< --each: a table of values, a file a row; empty: one file
  int threads = 0;     ///< 0: as many as the machine has
  scene::GltfOptions gltf;
  bool forgets_scene = false;
  bool is_unlit = false;
  bool is_compatible = false;
  std::string images;           ///< "embedded", "separate"; empty: by the container
  std::string image_format;     ///< "png", "jpg"; empty: not said
  CLI::App* options = nullptr;  ///< which were given
};

/// Refuses a name that is no model's. Throws InputError.
void check_model_name(const std::string& file);

/// Is a scene to be kept in this file?
bool keeps_scene(const Generate& command, const std::string& file);

/// What the plan needs to know of a file that is to be made with these options; an empty name is a .glb.
scene::Request model_request(const std::string& file, const scene::GltfOptions& options);

struct MadeFile {
  std::uint64_t objects = 0;
  std::uint64_t instances = 0;               ///< at least as many
  std::uint64_t triangles = 0;               ///< of a glTF's meshes, of a mesh file's instances
  std::uint64_t triangles_without_area = 0;  ///< left out of a quantized glTF
  std::optional<double> deviation;           ///< the largest that is known of an object in the world, metres
  std::uint64_t coarser_triangles = 0;       ///< of all coarser levels of detail
  std::size_t targets = 0;                   ///< the most that a mesh grows by
  double grow_error = 0;                     ///< metres
  std::uint64_t bytes = 0;                   ///< with what stands beside it
  scene::Ledger ledger;
  std::vector<scene::SceneFinding> findings;
};

/// Makes the document's objects and writes them to `file`, and to what a .gltf or an .obj has beside it;
/// looks for findings if it is to. Throws InputError for geometry and images that cannot be used, OutputError
/// for the disk.
MadeFile make_file(const scene::Document& document, const scene::Plan& plan, const std::string& file,
                   const scene::GltfOptions& options, bool looks_for_findings);

/// --each: a file for each row of the table, on all cores. A row that cannot be made is reported in a line
/// and the others are made; at the end that throws InputError with how many of each. Throws InputError before
/// any work for a table, a pointer or a pattern of names that cannot be, and OutputError at once when the
/// disk fails.
void generate_each(const Generate& command);

}  // namespace sweepkit::tools
