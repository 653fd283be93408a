// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sweepkit/scene/camera.hpp"
#include "sweepkit/scene/light.hpp"
#include "sweepkit/scene/material.hpp"
#include "sweepkit/sweep/grid_patch.hpp"
#include "sweepkit/texmap/image_file.hpp"
#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::scene {

/// Areas of a mesh that a contour made on its way, walls and caps.
struct SweptPart {
  enum class Along {
    kU,  ///< a revolve: the turn runs along u, from 0
    kV,  ///< a sweep: the trajectory runs along v, from 0
  };
  std::uint32_t first_area = 0;
  std::uint32_t area_count = 0;
  Along along = Along::kV;
};

/// Views of a mesh's own arrays; whoever made the scene keeps the meshes (scene::Model does).
struct MeshView {
  std::span<const glm::vec3> positions;  ///< relative to `origin`
  std::span<const glm::vec3> normals;
  std::span<const glm::vec2> texcoords;
  std::span<const sweep::Triangle> triangles;
  std::span<const sweep::GridPatch> patches;
  std::span<const sweep::Area> areas;
  glm::dvec3 origin{0.0};
  std::span<const glm::vec4> tangents;  ///< as sweep::find_tangents() has them; empty without a normal map
  std::vector<SweptPart> swept;         ///< in order of their areas; planes and mesh files are no part of it
};

/// One past the last triangle of each sheet of texture: areas that continue the one before belong to it.
std::vector<std::uint32_t> sheet_ends(const MeshView& mesh);

struct Object {
  std::string name;
  std::size_t mesh = 0;
  std::optional<std::size_t> material;  ///< none: the default Material
  glm::dmat4 world_from_object{1.0};    ///< affine, not singular
  /// Which of its instances this is: those of one object stand next to each other, from 0 on, and share name,
  /// mesh and material.
  std::uint32_t instance = 0;
};

/// A coarser mesh of the same curves as another one, in the same space.
struct CoarserMesh {
  std::size_t mesh = 0;
  /// It is to be shown where the object has at most this share of the picture's height; see add_levels().
  double height = 1;
};

/// Where an image texture was read from.
struct ImageSource {
  std::filesystem::path file;  ///< empty: nowhere
  texmap::ColorSpace color_space = texmap::ColorSpace::kSrgb;
};

/// Everything a picture or a file is made from, as plain data.
struct Scene {
  std::vector<MeshView> meshes;
  /// By mesh, the finest first; fewer than meshes, or none, where add_levels() was not asked.
  std::vector<std::vector<CoarserMesh>> coarser;
  std::vector<texmap::Texture> textures;  ///< a texture that nothing uses has no image
  std::vector<std::string> texture_names;
  std::vector<ImageSource> texture_sources;  ///< by texture; none need be known
  std::vector<Material> materials;
  std::vector<Object> objects;  ///< each instance is one
  std::vector<Light> lights;
  bool has_default_light = false;  ///< `lights` are not the scene's own but what look_from() gives it
  Camera camera;
  int width = 512;
  int height = 512;
  glm::vec3 background{0.0f};
  std::optional<texmap::ImageTexture> environment;  ///< in place of `background`: latitude and longitude
  glm::vec3 ambient{0.0f};
  int depth = 6;
  bool has_dimmed_shadows = false;  ///< an object in use transmits, and there is light: build() asks the plan
};

}  // namespace sweepkit::scene
