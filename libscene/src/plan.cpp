// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// One place decides what a piece of work needs. Each part is a row: the condition, and why in a few words.

#include "sweepkit/scene/plan.hpp"

#include <algorithm>

namespace sweepkit::scene {
namespace {

// What the document's objects really use.
struct Usage {
  std::vector<bool> textures;
  bool has_texture = false;
  bool has_image = false;
  bool has_color_image = false;
  bool has_procedural = false;
  bool has_normal_map = false;
  bool reads_uv = false;
  bool reflects = false;
  bool transmits = false;
  bool has_fresnel = false;  // on what reflects or transmits
  bool has_mesh_file = false;
};

Usage usage_of(const Document& document, bool has_normal_maps) {
  Usage usage;
  usage.textures.assign(document.textures.size(), false);
  for (const ObjectEntry& object : document.objects) {
    for (const Piece& piece : object.pieces)
      usage.has_mesh_file |= std::holds_alternative<MeshShape>(piece.shape);
    if (!object.material) continue;
    const Material& material = document.materials[*object.material];
    usage.reflects |= material.reflect > 0;
    usage.transmits |= material.transmit > 0;
    usage.has_fresnel |=
        material.fresnel != Fresnel::kNone && (material.reflect > 0 || material.transmit > 0);
    if (material.normal_map && has_normal_maps) {
      usage.textures[*material.normal_map] = true;
      usage.has_normal_map = usage.has_texture = usage.has_image = true;
    }
    if (!material.texture) continue;
    usage.textures[*material.texture] = true;
    usage.has_texture = true;
    if (const auto* procedural =
            std::get_if<texmap::Procedural>(&document.textures[*material.texture].source)) {
      usage.has_procedural = true;
      usage.reads_uv |= procedural->on == texmap::ProceduralOn::kUv;
    } else {
      usage.has_image = usage.has_color_image = true;
      usage.reads_uv = true;
    }
  }
  return usage;
}

// Those that a picture may do without, and that leave it as it is. (Tables and tiles are made as a filter
// reads them, what was not asked for - layers, more rays - would change what is drawn, and how textures that
// are there are looked up is settled.)
void switch_on(Plan& plan, const Usage& usage, bool has_light, const Document& document) {
  const auto row = [&](Part part) {
    Need& need = plan.needs[static_cast<std::size_t>(part)];
    if (!need.is_needed) need = {true, need.why + "; nothing is to be left out"};
  };
  for (const Part part : {Part::kHalfEdges, Part::kTexcoords, Part::kRows, Part::kTrees, Part::kRefractions,
                          Part::kShares, Part::kObjectTree}) {
    row(part);
  }
  if (!usage.has_texture) {
    row(Part::kFilteredNodes);
    row(Part::kDifferentials);
  }
  if (usage.has_mesh_file) row(Part::kLayouts);
  if (has_light) row(Part::kDimmedShadows);
  if (!document.textures.empty()) row(Part::kTextures);
  plan.textures.assign(document.textures.size(), true);
  plan.leaves_out = false;
}

}  // namespace

std::string_view part_name(Part part) {
  static constexpr std::array<std::string_view, kPartCount> kNames = {
      "half-edges",        "(u,v) layouts",
      "textures",          "baked textures",
      "glass thicknesses", "integral tables",
      "texture tiles",     "(u,v) at hits",
      "filtered nodes",    "ray differentials",
      "row buffers",       "intersection trees",
      "refractions",       "shares by angle",
      "shadow rays",       "dimmed shadows",
      "shadow edges",      "background image",
      "supersampling",     "refinement",
      "error estimate",    "layers",
      "tree over objects", "normal maps"};
  return kNames[static_cast<std::size_t>(part)];
}

Plan plan(const Document& document, const Request& request) {
  Usage usage = usage_of(document, request.has_normal_maps);
  const bool is_picture = request.product == Request::Product::kPicture;
  const bool is_mesh_file = request.product == Request::Product::kMeshFile;
  const bool can_hold_textures = !is_mesh_file || request.has_textures;
  const bool has_image = is_picture && usage.has_image;
  const bool has_tables = has_image && texmap::reads_table(request.filter);
  const bool is_filtered = usage.has_procedural
                               ? request.filter != texmap::Filter::kPoint
                               : usage.has_color_image && texmap::reads_footprint(request.filter);
  const bool has_footprints = is_picture && is_filtered;
  const bool has_light = !document.lights.empty() || !document.has_ambient;

  Plan plan;
  const auto row = [&](Part part, bool is_needed, std::string why) {
    plan.needs[static_cast<std::size_t>(part)] = {is_needed, std::move(why)};
  };
  const auto picture_row = [&](Part part, bool is_needed, std::string why) {
    row(part, is_picture && is_needed, is_picture ? std::move(why) : "no picture is drawn");
  };

  row(Part::kHalfEdges, request.has_half_edges,
      request.has_half_edges ? "someone walks them" : "nobody walks them");
  const bool shows_uv = is_picture ? usage.reads_uv || usage.has_normal_map || request.shows_texcoords
                                   : !is_mesh_file || request.has_texcoords;
  row(Part::kLayouts, usage.has_mesh_file && shows_uv,
      !usage.has_mesh_file ? "no object is a mesh file"
      : shows_uv           ? "mesh files without (u,v) are laid out over the texture"
      : is_mesh_file       ? "the file cannot hold (u,v)"
                           : "no texture reads (u,v)");
  row(Part::kTextures, usage.has_texture && can_hold_textures,
      !usage.has_texture  ? "no material in use has a texture"
      : can_hold_textures ? "materials in use have textures"
                          : "the file cannot hold textures");
  if (is_mesh_file) {
    row(Part::kBakes, usage.has_procedural && can_hold_textures,
        !usage.has_procedural ? "no procedural texture is used"
        : can_hold_textures   ? "the file cannot hold a procedural texture"
                              : "the file cannot hold textures");
  } else {
    const bool is_bake = request.product == Request::Product::kTexture;
    row(Part::kBakes, is_bake,
        is_bake ? "it is what was asked for" : "a picture evaluates procedural textures where it hits them");
  }
  row(Part::kThicknesses, is_mesh_file && request.has_thicknesses && usage.transmits,
      !is_mesh_file             ? "no file of meshes is made"
      : !usage.transmits        ? "no material in use transmits"
      : request.has_thicknesses ? "materials in use transmit"
                                : "the file cannot hold them");
  const char* no_image = "no image texture is used";
  const std::string filter = "the filter is " + std::string(texmap::filter_name(request.filter));
  picture_row(Part::kTables, has_tables, usage.has_image ? filter : no_image);
  picture_row(Part::kTiles, has_image && !has_tables, usage.has_image ? filter : no_image);
  picture_row(Part::kTexcoords, usage.reads_uv,
              usage.reads_uv ? "textures are looked up by (u,v)" : "no texture of colours reads (u,v)");
  const bool has_neighbours = has_footprints && request.has_neighbours;
  // The rays that refine or check a pixel have no neighbours to look at.
  const bool has_differentials =
      has_footprints && (request.has_differentials || request.is_refined || request.estimates_error);
  const bool has_shadow_edges = has_light && request.has_smooth_shadows;
  const std::string no_footprints =
      usage.has_color_image || usage.has_procedural ? filter : "no texture of colours is used";
  picture_row(Part::kFilteredNodes, has_neighbours,
              has_neighbours   ? "textured hits are filtered over their neighbours"
              : has_footprints ? "footprints come from ray differentials"
                               : no_footprints);
  picture_row(Part::kDifferentials, has_differentials,
              has_differentials
                  ? has_neighbours ? "for textured hits without neighbours" : "they were asked for"
              : has_footprints ? "footprints come from neighbours alone"
                               : no_footprints);
  picture_row(Part::kRows, has_neighbours || has_shadow_edges,
              has_neighbours     ? "the filter looks at the rows above and below"
              : has_shadow_edges ? "shadow edges are averaged with the rows above and below"
                                 : "one row is enough where no neighbour is looked at");
  const bool has_paths = usage.reflects || usage.transmits;
  const bool has_trees = has_paths && document.depth > 0;
  const std::string no_depth = "the depth is 0";
  picture_row(Part::kTrees, has_trees,
              has_trees   ? "materials in use reflect or transmit"
              : has_paths ? no_depth
                          : "no material in use reflects or transmits");
  const bool has_refractions = usage.transmits && document.depth > 0;
  picture_row(Part::kRefractions, has_refractions,
              has_refractions   ? "materials in use transmit"
              : usage.transmits ? no_depth
                                : "no material in use transmits");
  const bool varies = usage.transmits || usage.has_fresnel;
  picture_row(Part::kShares, varies && document.depth > 0,
              !varies               ? "no share depends on the angle"
              : document.depth == 0 ? no_depth
              : usage.has_fresnel   ? "materials in use have Fresnel's shares"
                                    : "total reflection mirrors what is transmitted elsewhere");
  picture_row(Part::kShadows, has_light, has_light ? "there is a light" : "there is no light, only ambient");
  picture_row(Part::kDimmedShadows, has_light && usage.transmits,
              !usage.transmits ? "no material in use transmits"
              : has_light      ? "materials in use transmit, and there is a light"
                               : "there is no light, only ambient");
  picture_row(Part::kShadowEdges, has_shadow_edges,
              !has_light         ? "there is no light, only ambient"
              : has_shadow_edges ? "shadows are to be smooth"
                                 : "shadows are to be hard");
  picture_row(Part::kEnvironment, document.environment.has_value(),
              document.environment ? "the background is an image" : "the background is a colour");
  picture_row(Part::kSupersampling, request.is_supersampled,
              request.is_supersampled ? "it was asked for" : "it was not asked for");
  picture_row(Part::kRefinement, request.is_refined,
              request.is_refined ? "it was asked for" : "it was not asked for");
  picture_row(Part::kErrorEstimate, request.estimates_error,
              request.estimates_error ? "it was asked for" : "it was not asked for");
  picture_row(Part::kLayers, request.has_layers,
              request.has_layers ? "they were asked for" : "they were not asked for");
  const bool has_several =
      document.objects.size() > 1 || std::ranges::any_of(document.objects, [](const ObjectEntry& object) {
        return object.instances.size() > 1;
      });
  picture_row(Part::kObjectTree, has_several,
              has_several ? "there are several objects" : "there is one object");

  const bool has_tangents = is_picture || (is_mesh_file && request.has_tangents);
  row(Part::kNormalMaps, usage.has_normal_map && has_tangents,
      !usage.has_normal_map ? "no material in use has a normal map"
      : has_tangents        ? "materials in use have normal maps, which lie in the tangents' frames"
      : is_mesh_file        ? "the file cannot hold tangents"
                            : "no surface is shaded");

  plan.texture_memory = request.texture_memory;
  if (!can_hold_textures) usage.textures.assign(document.textures.size(), false);
  plan.textures = usage.textures;
  if (is_picture && !request.leaves_out) switch_on(plan, usage, has_light, document);
  plan.sampled.assign(document.textures.size(), false);
  for (std::size_t i = 0; i < document.textures.size(); ++i) {
    plan.sampled[i] =
        is_picture && plan.textures[i] && std::holds_alternative<ImageEntry>(document.textures[i].source);
  }
  return plan;
}

void Ledger::add(const Ledger& other) {
  for (std::size_t i = 0; i < kPartCount; ++i) {
    costs[i].bytes += other.costs[i].bytes;
    costs[i].calls += other.costs[i].calls;
  }
}

}  // namespace sweepkit::scene
