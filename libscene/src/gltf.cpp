// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// tinygltf is known to this writer's files alone (gltf*.cpp). A glTF is put together in memory - one buffer,
// its views and accessors, the images - and becomes bytes in gltf_container.cpp.

#include "sweepkit/scene/gltf.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "gltf_arrays.hpp"
#include "gltf_buffer.hpp"
#include "gltf_camera.hpp"
#include "gltf_container.hpp"
#include "gltf_extras.hpp"
#include "gltf_levels.hpp"
#include "gltf_lights.hpp"
#include "gltf_materials.hpp"
#include "gltf_mirror.hpp"
#include "gltf_motion.hpp"
#include "gltf_primitive.hpp"
#include "gltf_textures.hpp"
#include "gltf_transform.hpp"
#include "json_text.hpp"
#include "message_text.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/strict_math.hpp"
#include "sweepkit/sweep/tangents.hpp"

namespace sweepkit::scene {
namespace {

std::vector<std::byte> to_bytes(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

class Writer {
 public:
  Writer(const Scene& scene, const Plan& plan, const std::filesystem::path& file, const GltfOptions& options)
      : scene_(scene),
        options_(options),
        stem_(file == "-" ? "scene" : file.stem().string()),
        bounds_(needs_bounds(options) ? bounds_of(scene) : Bounds()),
        pivot_(options.turntable_seconds > 0 ? bounds_.center() : glm::dvec3(0.0)),
        is_binary_(file.extension() != ".gltf"),
        buffer_(model_, {options.is_quantized, options.is_packed}),
        textures_(model_, buffer_, result_, scene, options, stem_,
                  options.images_in == GltfImages::kSeparate ||
                      (options.images_in == GltfImages::kByContainer && !is_binary_)),
        materials_(model_, textures_, result_, extensions_, scene, plan, options) {
    model_.asset.version = "2.0";
    model_.asset.generator = "sweepkit " SWEEPKIT_VERSION;
    if (options.grow_seconds > 0 && (options.is_quantized || options.is_packed)) {
      throw InputError("what grows has morph targets, which are neither quantized nor packed; leave one out");
    }
    if (options.grow_seconds > 0 && !scene.coarser.empty()) {
      throw InputError("what grows has one mesh, and levels of detail have several; leave one out");
    }
    if (!is_utf8(options.copyright)) throw InputError("the copyright is no UTF-8 text");
    model_.asset.copyright = options.copyright;
  }

  GltfPieces write() {
    tinygltf::Scene scene;
    if (!options_.is_minimal) scene.name = "scene";
    const auto is_first = [](const Object& object) { return object.instance == 0; };
    for (auto first = scene_.objects.begin(); first != scene_.objects.end();) {
      const auto end = std::find_if(first + 1, scene_.objects.end(), is_first);
      if (!options_.object || first->name == *options_.object) {
        scene.nodes.push_back(static_cast<int>(model_.nodes.size()));
        add_object({first, end});
      }
      first = end;
    }
    if (scene.nodes.empty()) refuse_selection();
    if (options_.turntable_seconds > 0) add_turntable_over(scene.nodes);
    if (options_.grow_seconds > 0) {
      if (growing_.empty()) throw InputError("nothing here is swept or revolved, so that nothing can grow");
      add_growing(model_, buffer_, growing_, options_.grow_seconds);
    }
    if (!options_.is_minimal) {
      scene.nodes.push_back(add_camera(model_, scene_, bounds_));
      if (options_.look == GltfLook::kFull && !scene_.has_default_light) {
        const std::vector<int> lights = add_lights(model_, scene_.lights, bounds_);
        scene.nodes.insert(scene.nodes.end(), lights.begin(), lights.end());
      }
    }
    if (options_.is_minimal) {
      for (tinygltf::Animation& animation : model_.animations) animation.name.clear();
    }
    model_.scenes.push_back(std::move(scene));
    model_.defaultScene = 0;
    if (options_.is_quantized) {
      extensions_.insert("KHR_mesh_quantization");
      model_.extensionsRequired.emplace_back("KHR_mesh_quantization");
    }
    if (buffer_.unpacked_bytes > 0) {
      extensions_.insert("EXT_meshopt_compression");
      model_.extensionsRequired.emplace_back("EXT_meshopt_compression");
    }
    model_.extensionsUsed.assign(extensions_.begin(), extensions_.end());
    return files();
  }

 private:
  // For the camera's depths, the lights' brightness and the turntable's middle.
  static bool needs_bounds(const GltfOptions& options) {
    return !options.is_minimal || options.turntable_seconds > 0;
  }

  [[noreturn]] void refuse_selection() const {
    if (!options_.object) throw InputError("the scene has no objects to write");
    std::string names;
    for (const Object& object : scene_.objects) {
      if (object.instance == 0) names += (names.empty() ? "" : ", ") + in_quotes(object.name);
    }
    throw InputError("there is no object " + in_quotes(*options_.object) + "; there is " + names);
  }

  // The objects' nodes are placed about the middle of all (add_node), which the turntable's node is at.
  void add_turntable_over(std::vector<int>& nodes) {
    const int turntable = static_cast<int>(model_.nodes.size());
    tinygltf::Node node;
    if (!options_.is_minimal) node.name = "turntable";
    node.translation = {pivot_.x, pivot_.y, pivot_.z};
    node.children = std::move(nodes);
    model_.nodes.push_back(std::move(node));
    nodes = {turntable};
    add_turntable(model_, buffer_, turntable, options_.turntable_seconds);
  }

  // Of a mesh that is to be written; none where it does not grow.
  const Growth* growth_of(std::size_t mesh) {
    if (!(options_.grow_seconds > 0)) return nullptr;
    const auto [found, is_new] = growths_.try_emplace(mesh);
    if (is_new) {
      found->second = grow(view_of(mesh));
      if (found->second) {
        result_.targets = std::max(result_.targets, found->second->states.size());
        result_.grow_error = std::max(result_.grow_error, found->second->error);
      }
    }
    return found->second ? &*found->second : nullptr;
  }

  GltfPieces files() {
    GltfContainer container{.views = buffer_.views,
                            .buffer_bytes = buffer_.size,
                            .unpacked_bytes = buffer_.unpacked_bytes,
                            .extras = options_.is_minimal ? "" : gltf_extras(options_),
                            .is_indented = !is_binary_};
    GltfPieces made{.kept = std::move(buffer_.kept),
                    .ledger = result_.ledger,
                    .triangles_without_area = result_.triangles_without_area,
                    .targets = result_.targets,
                    .grow_error = result_.grow_error};
    const auto add = [&](const std::string& name, std::vector<std::byte> bytes) {
      made.files.push_back({name, {made.kept.emplace_back(std::move(bytes))}});
    };
    for (NamedBytes& image : result_.files) add(image.name, std::move(image.bytes));
    std::vector<std::span<const std::byte>>& pieces = buffer_.pieces;
    if (is_binary_) {
      const std::string json = gltf_json(model_, container);
      add(stem_ + ".glb", glb_head(json, buffer_.size));
      std::vector<std::span<const std::byte>>& whole = made.files.back().pieces;
      whole.insert(whole.end(), pieces.begin(), pieces.end());
      whole.push_back(made.kept.emplace_back((4 - buffer_.size % 4) % 4));
      return made;
    }
    const std::string name = stem_ + ".bin";
    container.buffer_uri = percent_encoded(name);
    made.files.push_back({name, std::move(pieces)});
    add(stem_ + ".gltf", to_bytes(gltf_json(model_, container)));
    return made;
  }

  std::string name_of(const Object& object) const { return options_.is_minimal ? "" : object.name; }

  // A small file has what nothing reads left out.
  bool needs_texcoords(const GltfMaps& maps) const {
    return !(options_.is_minimal || options_.is_packed) || maps != GltfMaps();
  }

  // Its instances. One is a node with the mesh; several are such nodes without names under the object's.
  void add_object(std::span<const Object> instances) {
    const Object& first = instances.front();
    if (scene_.meshes[first.mesh].triangles.empty())
      throw InputError("the object " + in_quotes(first.name) + " has no triangles");
    std::vector<CoarserMesh> levels = {{first.mesh, 1}};
    if (first.mesh < scene_.coarser.size()) {
      const std::vector<CoarserMesh>& coarser = scene_.coarser[first.mesh];
      levels.insert(levels.end(), coarser.begin(), coarser.end());
    }
    const bool is_mirrored = all_mirror(instances);
    std::vector<texmap::UvTransform> transforms;
    const GltfMaps maps = materials_.maps_of(first, transforms);
    std::vector<int> meshes;
    for (const CoarserMesh& level : levels) {
      const MeshView& own = scene_.meshes[level.mesh];
      if (!own.tangents.empty() && is_mirrored) mirrored_.try_emplace(level.mesh, own);
      meshes.push_back(add_mesh(first, level.mesh, maps, transforms));
    }
    if (instances.size() == 1) {
      const std::size_t node = add_nodes(first, levels, meshes);
      model_.nodes[node].name = name_of(first);
      for (std::size_t i = 1; i < levels.size() && !options_.is_minimal; ++i) {
        model_.nodes[node + i].name = first.name + " level " + std::to_string(i);
      }
      return;
    }
    const std::size_t group = model_.nodes.size();
    model_.nodes.emplace_back();
    model_.nodes.back().name = name_of(instances.front());
    for (const Object& instance : instances) {
      const std::size_t node = add_nodes(instance, levels, meshes);
      model_.nodes[group].children.push_back(static_cast<int>(node));
    }
  }

  // The node that stands in the scene, which those of coarser meshes follow; no other node points at them.
  std::size_t add_nodes(const Object& object, std::span<const CoarserMesh> levels,
                        std::span<const int> meshes) {
    const std::size_t node = model_.nodes.size();
    for (std::size_t i = 0; i < levels.size(); ++i) add_node(object, levels[i].mesh, meshes[i]);
    if (levels.size() > 1) {
      point_at_levels(model_, node, levels);
      extensions_.insert(kLevelsExtension);
    }
    return node;
  }

  // As it stands in the file.
  MeshView view_of(std::size_t mesh) const {
    const auto mirrored = mirrored_.find(mesh);
    const MeshView& own = scene_.meshes[mesh];
    return mirrored != mirrored_.end() ? mirrored->second.view(own) : own;
  }

  // Of a mesh in floats the identity.
  const PositionGrid& grid_of(std::size_t mesh) {
    const auto [found, is_new] = grids_.try_emplace(mesh);
    if (is_new && options_.is_quantized) {
      const MeshView view = view_of(mesh);
      const int usual = options_.is_packed ? bits_for_cells(view.positions, view.triangles) : 16;
      found->second = position_grid(view.positions, options_.position_bits.value_or(usual));
    }
    return found->second;
  }

  void add_node(const Object& object, std::size_t mesh, int entry) {
    const PositionGrid& grid = grid_of(mesh);
    glm::dmat4 node_from_mesh(1.0);
    node_from_mesh[3] = glm::dvec4(scene_.meshes[mesh].origin, 1);
    if (mirrored_.contains(mesh)) node_from_mesh[0] = -node_from_mesh[0];
    glm::dmat4 mesh_from_grid = glm::dmat4(glm::dmat3(grid.step));
    mesh_from_grid[3] = glm::dvec4(grid.offset, 1);
    node_from_mesh = node_from_mesh * mesh_from_grid;
    glm::dmat4 placement = object.world_from_object * node_from_mesh;
    placement[3] -= glm::dvec4(pivot_, 0);
    tinygltf::Node node;
    node.mesh = entry;
    if (const Growth* growth = growth_of(mesh))
      growing_.push_back({static_cast<int>(model_.nodes.size()), growth});
    const std::optional<NodeTransform> transform = decompose(placement);
    if (!transform) {
      throw InputError("the object " + in_quotes(object.name) +
                       " is sheared by an instance, which glTF cannot place; give that instance one scale "
                       "for all directions");
    }
    place(node, *transform);
    model_.nodes.push_back(std::move(node));
  }

  int add_mesh(const Object& object, std::size_t index, const GltfMaps& maps,
               std::span<const texmap::UvTransform> transforms) {
    const MeshView mesh = view_of(index);
    const int material = materials_.add(object, maps, grid_of(index).step);
    GltfVertices vertices{.lasts = !mirrored_.contains(index)};
    vertices.tangents.assign(mesh.tangents.begin(), mesh.tangents.end());
    if (needs_texcoords(maps)) {
      vertices.texcoords = gltf_texcoords(mesh, transforms);
      if (!mesh.tangents.empty() && !transforms.empty()) vertices.second_texcoords = gltf_texcoords(mesh, {});
      if (mesh.tangents.empty() && options_.has_tangents) {
        vertices.tangents =
            sweep::find_tangents(mesh.positions, mesh.normals, mesh.texcoords, mesh.triangles);
      }
    }
    const std::optional<PositionGrid> grid =
        options_.is_quantized ? std::optional(grid_of(index)) : std::nullopt;
    auto [primitive, without_area] = add_primitive(buffer_, mesh, vertices, grid, options_.is_packed);
    if (primitive.indices < 0) {
      throw InputError("the object " + in_quotes(object.name) +
                       " is too thin to be quantized: no triangle keeps its area");
    }
    primitive.material = material;
    if (const Growth* growth = growth_of(index)) add_targets(primitive, buffer_, *growth);
    result_.triangles_without_area += without_area;
    tinygltf::Mesh entry;
    entry.name = name_of(object);
    entry.primitives.push_back(std::move(primitive));
    model_.meshes.push_back(std::move(entry));
    return static_cast<int>(model_.meshes.size()) - 1;
  }

  const Scene& scene_;
  const GltfOptions& options_;
  std::string stem_;
  Bounds bounds_;
  glm::dvec3 pivot_;
  bool is_binary_;
  tinygltf::Model model_;
  GltfFile result_;
  GltfBuffer buffer_;
  GltfTextures textures_;
  std::set<std::string> extensions_;
  GltfMaterials materials_;
  std::map<std::size_t, PositionGrid> grids_;             // by mesh
  std::map<std::size_t, MirroredMesh> mirrored_;          // by mesh: those that no placement shows unmirrored
  std::map<std::size_t, std::optional<Growth>> growths_;  // by mesh
  std::vector<GrowingNode> growing_;
};

}  // namespace

GltfPieces make_gltf_pieces(const Scene& scene, const Plan& plan, const std::filesystem::path& file,
                            const GltfOptions& options) {
  return Writer(scene, plan, file, options).write();
}

GltfFile make_gltf(const Scene& scene, const Plan& plan, const std::filesystem::path& file,
                   const GltfOptions& options) {
  GltfPieces made = make_gltf_pieces(scene, plan, file, options);
  GltfFile whole{.ledger = made.ledger,
                 .triangles_without_area = made.triangles_without_area,
                 .targets = made.targets,
                 .grow_error = made.grow_error};
  for (const GltfPieces::File& part : made.files) {
    std::size_t size = 0;
    for (const auto& piece : part.pieces) size += piece.size();
    NamedBytes bytes{.name = part.name};
    bytes.bytes.reserve(size);
    for (const auto& piece : part.pieces) bytes.bytes.insert(bytes.bytes.end(), piece.begin(), piece.end());
    whole.files.push_back(std::move(bytes));
  }
  return whole;
}

}  // namespace sweepkit::scene
