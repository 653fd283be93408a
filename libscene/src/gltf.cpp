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
#include <numbers>
#include <set>

#include "gltf_arrays.hpp"
#include "gltf_buffer.hpp"
#include "gltf_container.hpp"
#include "gltf_extras.hpp"
#include "gltf_material_entry.hpp"
#include "gltf_textures.hpp"
#include "gltf_transform.hpp"
#include "json_text.hpp"
#include "mean_chord.hpp"
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
        plan_(plan),
        options_(options),
        stem_(file == "-" ? "scene" : file.stem().string()),
        is_binary_(file.extension() != ".gltf"),
        buffer_(model_),
        textures_(model_, buffer_, result_, scene, options, stem_,
                  options.images_in == GltfImages::kSeparate ||
                      (options.images_in == GltfImages::kByContainer && !is_binary_)) {
    model_.asset.version = "2.0";
    model_.asset.generator = "sweepkit " SWEEPKIT_VERSION;
    if (!is_utf8(options.copyright)) throw InputError("the copyright is no UTF-8 text");
    model_.asset.copyright = options.copyright;
  }

  GltfFile write() {
    tinygltf::Scene scene;
    scene.name = "scene";
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
    scene.nodes.push_back(static_cast<int>(model_.nodes.size()));
    add_camera();
    model_.scenes.push_back(std::move(scene));
    model_.defaultScene = 0;
    model_.extensionsUsed.assign(extensions_.begin(), extensions_.end());
    add_files();
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse_selection() const {
    if (!options_.object) throw InputError("the scene has no objects to write");
    std::string names;
    for (const Object& object : scene_.objects) {
      if (object.instance == 0) names += (names.empty() ? "" : ", ") + in_quotes(object.name);
    }
    throw InputError("there is no object " + in_quotes(*options_.object) + "; there is " + names);
  }

  void add_files() {
    GltfContainer container{
        .buffer_bytes = buffer_.bytes.size(), .extras = gltf_extras(options_), .is_indented = !is_binary_};
    if (is_binary_) {
      const std::string json = gltf_json(model_, container);
      result_.files.push_back({stem_ + ".glb", glb_bytes(json, std::move(buffer_.bytes))});
      return;
    }
    const std::string name = stem_ + ".bin";
    container.buffer_uri = percent_encoded(name);
    result_.files.push_back({name, std::move(buffer_.bytes)});
    result_.files.push_back({stem_ + ".gltf", to_bytes(gltf_json(model_, container))});
  }

  GltfBody body_of(const Object& object) {
    if (!plan_.needs_part(Part::kThicknesses)) return {};
    const auto [found, is_new] = thicknesses_.try_emplace(object.mesh);
    if (is_new) {
      const MeshView& mesh = scene_.meshes[object.mesh];
      found->second = mean_chord(mesh);
      result_.ledger[Part::kThicknesses].calls += 1;
      result_.ledger[Part::kThicknesses].bytes += mean_chord_bytes(mesh);
    }
    return {found->second, std::cbrt(std::abs(glm::determinant(glm::dmat3(object.world_from_object))))};
  }

  // One for each set of terms and texture in use.
  int add_material(const Object& object, std::vector<texmap::UvTransform>& transforms) {
    const Material material = object.material ? scene_.materials[*object.material] : Material{};
    const GltfBody body = material.transmit > 0 ? body_of(object) : GltfBody{};
    std::optional<int> texture;
    if (material.texture && plan_.textures[*material.texture]) {
      const texmap::Texture& source = scene_.textures[*material.texture];
      if (const auto* procedural = std::get_if<texmap::Procedural>(&source)) {
        if (plan_.needs_part(Part::kBakes)) {
          texture = textures_.baked_texture(object, *procedural, transforms);
        }
      } else {
        texture = textures_.image_texture(*material.texture);
      }
    }
    const GltfMaterial terms = to_gltf(material, options_.look, body);
    const auto same = std::find_if(materials_.begin(), materials_.end(), [&](const MaterialInUse& one) {
      return one.terms == terms && one.texture == texture;
    });
    if (same != materials_.end()) return static_cast<int>(same - materials_.begin());
    materials_.push_back({terms, texture});
    model_.materials.push_back(
        material_entry(object.material ? material.name : "default", terms, texture, extensions_));
    return static_cast<int>(materials_.size()) - 1;
  }

  // Its instances. One is a node with the mesh; several are such nodes without names under the object's.
  void add_object(std::span<const Object> instances) {
    const int mesh = add_mesh(instances.front());
    if (instances.size() == 1) {
      add_node(instances.front(), mesh);
      model_.nodes.back().name = instances.front().name;
      return;
    }
    const std::size_t group = model_.nodes.size();
    model_.nodes.emplace_back();
    model_.nodes.back().name = instances.front().name;
    for (const Object& instance : instances) {
      model_.nodes[group].children.push_back(static_cast<int>(model_.nodes.size()));
      add_node(instance, mesh);
    }
  }

  void add_node(const Object& object, int mesh) {
    glm::dmat4 node_from_mesh(1.0);
    node_from_mesh[3] = glm::dvec4(scene_.meshes[object.mesh].origin, 1);
    tinygltf::Node node;
    node.mesh = mesh;
    place(node, object.world_from_object * node_from_mesh, object.name);
    model_.nodes.push_back(std::move(node));
  }

  int add_mesh(const Object& object) {
    const MeshView& mesh = scene_.meshes[object.mesh];
    if (mesh.triangles.empty())
      throw InputError("the object " + in_quotes(object.name) + " has no triangles");
    std::vector<texmap::UvTransform> transforms;
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = add_material(object, transforms);
    primitive.indices = buffer_.add_indices(mesh.triangles, mesh.positions.size());
    primitive.attributes["POSITION"] = buffer_.add_positions(mesh.positions);
    primitive.attributes["NORMAL"] = buffer_.add_vertices(mesh.normals);
    if (options_.has_tangents) {
      primitive.attributes["TANGENT"] = buffer_.add_vertices(
          sweep::find_tangents(mesh.positions, mesh.normals, mesh.texcoords, mesh.triangles));
    }
    primitive.attributes["TEXCOORD_0"] = buffer_.add_vertices(gltf_texcoords(mesh, transforms));
    tinygltf::Mesh entry;
    entry.name = object.name;
    entry.primitives.push_back(std::move(primitive));
    model_.meshes.push_back(std::move(entry));
    return static_cast<int>(model_.meshes.size()) - 1;
  }

  static void place(tinygltf::Node& node, const glm::dmat4& world_from_node, const std::string& name) {
    const std::optional<NodeTransform> transform = decompose(world_from_node);
    if (!transform) {
      throw InputError("the object " + in_quotes(name) +
                       " is sheared by an instance, which glTF cannot place; give that instance one scale "
                       "for all directions");
    }
    const auto& [t, r, s] = *transform;
    if (t != glm::dvec3(0.0)) node.translation = {t.x, t.y, t.z};
    if (r != glm::dvec4(0, 0, 0, 1)) node.rotation = {r.x, r.y, r.z, r.w};
    if (s != glm::dvec3(1.0)) node.scale = {s.x, s.y, s.z};
  }

  void add_camera() {
    const Camera& from = scene_.camera;
    tinygltf::Camera camera;
    camera.type = "perspective";
    camera.name = "camera";
    camera.perspective.yfov = from.fov_deg * (std::numbers::pi / 180);
    camera.perspective.aspectRatio = static_cast<double>(scene_.width) / scene_.height;
    const double distance = glm::distance(from.target, from.eye);
    camera.perspective.znear = 1e-3 * distance;
    camera.perspective.zfar = 1e3 * distance;
    model_.cameras.push_back(camera);
    tinygltf::Node node;
    node.name = "camera";
    node.camera = 0;
    glm::dmat4 placement(world_from_camera(from));
    placement[3] = glm::dvec4(from.eye, 1);
    place(node, placement, node.name);
    node.scale.clear();  // 1 but for rounding; a camera has none
    model_.nodes.push_back(std::move(node));
  }

  struct MaterialInUse {
    GltfMaterial terms;
    std::optional<int> texture;
  };

  const Scene& scene_;
  const Plan& plan_;
  const GltfOptions& options_;
  std::string stem_;
  bool is_binary_;
  tinygltf::Model model_;
  GltfFile result_;
  GltfBuffer buffer_;
  GltfTextures textures_;
  std::vector<MaterialInUse> materials_;                      // as model_.materials
  std::map<std::size_t, std::optional<double>> thicknesses_;  // by mesh
  std::set<std::string> extensions_;
};

}  // namespace

GltfFile make_gltf(const Scene& scene, const Plan& plan, const std::filesystem::path& file,
                   const GltfOptions& options) {
  return Writer(scene, plan, file, options).write();
}

}  // namespace sweepkit::scene
