// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sweepkit/scene/document.hpp"
#include "sweepkit/texmap/filter.hpp"
#include "sweepkit/texmap/texture_memory.hpp"

namespace sweepkit::scene {

/// The parts of the work that a scene may not need. A new one is a row here, one in part_name() and one in
/// plan().
enum class Part {
  kHalfEdges,      ///< OpenMesh's connectivity
  kLayouts,        ///< (u,v) laid out over the texture for mesh files that have none
  kTextures,       ///< texture images read, procedural textures set up
  kBakes,          ///< procedural textures turned into images for a file
  kThicknesses,    ///< how thick glass is, told in a file
  kTables,         ///< tables of integrals that the filter reads, and tiles of the texels they sum up
  kTiles,          ///< tiles of image textures and of their smaller copies
  kTexcoords,      ///< (u,v) interpolated at hits
  kFilteredNodes,  ///< neighbours' boxes made and looked up
  kDifferentials,  ///< derivatives of rays carried along their paths
  kRows,           ///< the two neighbouring row buffers
  kTrees,          ///< nodes below the primary hit
  kRefractions,    ///< children by refraction
  kShares,         ///< the mirrored and the refracted share kept at nodes, where they depend on the angle
  kShadows,        ///< shadow rays
  kDimmedShadows,  ///< shadow rays followed through what transmits
  kShadowEdges,    ///< what they find averaged over the neighbouring pixels
  kEnvironment,    ///< a picture as background, looked up by direction
  kSupersampling,  ///< the larger picture that is shrunk
  kRefinement,     ///< pixels compared with their neighbours and given more rays
  kErrorEstimate,  ///< what is known of each pixel's error, and pixels drawn again to check it
  kLayers,         ///< depth, normals and the like beside the picture
  kObjectTree,     ///< the tree over the objects' boxes
  kNormalMaps,     ///< tangents, and normals looked up in their frames
};
inline constexpr std::size_t kPartCount = static_cast<std::size_t>(Part::kNormalMaps) + 1;

std::string_view part_name(Part part);  ///< "half-edges", "integral tables", ...

struct Need {
  bool is_needed = false;
  std::string why;  ///< "no material has a texture"
};

/// What this piece of work needs, worked out once before it. Plain data that every stage reads.
struct Plan {
  std::array<Need, kPartCount> needs;
  std::vector<bool> textures;  ///< by Document::textures: is it read at all?
  std::size_t texture_memory = texmap::kDefaultTextureMemory;
  std::vector<bool> sampled;  ///< by Document::textures: is it an image that a picture shows?
  /// Otherwise every stage does for all what it has to do for some: (u,v) and footprints of what has no
  /// texture.
  bool leaves_out = true;

  bool needs_part(Part part) const { return needs[static_cast<std::size_t>(part)].is_needed; }
};

/// What is made, as far as it decides what is needed.
struct Request {
  enum class Product { kPicture, kMeshFile, kTexture };
  Product product = Product::kPicture;
  bool has_half_edges = false;  ///< someone walks the half-edges
  texmap::Filter filter = texmap::Filter::kPoint;
  std::size_t texture_memory = texmap::kDefaultTextureMemory;  ///< bytes that a picture's textures may fill
  bool is_supersampled = false;
  bool is_refined = false;          ///< pixels that differ from their neighbours have more rays
  bool estimates_error = false;     ///< how far the picture is from the true one is told, too
  bool has_smooth_shadows = false;  ///< shadow edges are averaged over the neighbours
  bool has_layers = false;          ///< something besides colours is told of each pixel
  bool shows_texcoords = false;     ///< (u,v) is, of that
  bool has_textures = true;         ///< the mesh file made can hold textures
  bool has_texcoords = true;        ///< it can hold (u,v)
  bool has_thicknesses = true;      ///< it can tell how thick glass is
  bool has_normal_maps = true;      ///< what is made shows normal maps
  bool has_tangents = true;         ///< a mesh file can hold tangents
  bool has_neighbours = true;       ///< footprints are made from the neighbouring pixels' hits
  bool has_differentials = true;    ///< where there are none, or at all, from the rays' derivatives
  /// Otherwise every part of a picture that can be switched on without changing it is, needed or not: what
  /// leaving out saves is measured against that.
  bool leaves_out = true;
};

Plan plan(const Document& document, const Request& request);

/// What a part really cost: a part left out costs no byte and no call.
struct Cost {
  std::uint64_t bytes = 0;
  std::uint64_t calls = 0;
};

struct Ledger {
  std::array<Cost, kPartCount> costs;

  Cost& operator[](Part part) { return costs[static_cast<std::size_t>(part)]; }
  const Cost& operator[](Part part) const { return costs[static_cast<std::size_t>(part)]; }
  void add(const Ledger& other);
};

}  // namespace sweepkit::scene
