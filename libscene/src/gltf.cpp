// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The one file that knows tinygltf. A glTF is put together in memory - one buffer, its views and accessors,
// the images - and written to a stream: tinygltf's own file writing reports success for a full disk and a
// missing folder, and writes no images.

#include "sweepkit/scene/gltf.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <streambuf>

#include "gltf_arrays.hpp"
#include "gltf_material.hpp"
#include "gltf_transform.hpp"
#include "message_text.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/bake_over.hpp"
#include "sweepkit/scene/image_store.hpp"
#include "sweepkit/sweep/tangents.hpp"
#include "sweepkit/texmap/bake.hpp"

namespace sweepkit::scene {
namespace {

// A .glb over 4 GiB wraps its length round without a word, and 2 GiB is what readers can be trusted with.
constexpr std::size_t kLargestBuffer = std::size_t{1} << 31;

std::vector<std::byte> to_bytes(std::string_view text) {
  std::vector<std::byte> out(text.size());
  std::memcpy(out.data(), text.data(), text.size());
  return out;
}

// A stream's end that keeps the bytes, without std::ostringstream's second copy of a large file.
class ByteSink : public std::streambuf {
 public:
  std::vector<std::byte> bytes;

 protected:
  std::streamsize xsputn(const char* from, std::streamsize count) override {
    const auto* first = reinterpret_cast<const std::byte*>(from);
    bytes.insert(bytes.end(), first, first + count);
    return count;
  }
  int_type overflow(int_type c) override {
    if (!traits_type::eq_int_type(c, traits_type::eof())) bytes.push_back(static_cast<std::byte>(c));
    return traits_type::not_eof(c);
  }
};

class Writer {
 public:
  Writer(const Scene& scene, const Plan& plan, const std::filesystem::path& file, const GltfOptions& options)
      : scene_(scene),
        plan_(plan),
        options_(options),
        images_(options.images != nullptr ? *options.images : own_images_),
        stem_(file == "-" ? "scene" : file.stem().string()),
        is_binary_(file.extension() != ".gltf") {
    model_.asset.version = "2.0";
    model_.asset.generator = "sweepkit " SWEEPKIT_VERSION;
    model_.buffers.emplace_back();
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
    if (is_binary_) {
      result_.files.push_back({stem_ + ".glb", serialized()});
    } else {
      add_text_and_buffer();
    }
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

  std::vector<std::byte> serialized() {
    ByteSink sink;
    std::ostream stream(&sink);
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, stream, !is_binary_, is_binary_)) {
      throw OutputError("the glTF could not be written");
    }
    return std::move(sink.bytes);
  }

  // tinygltf puts a buffer into the text as base64. So it writes one byte in the data's place, and the buffer
  // is then described as what it is: a file beside.
  void add_text_and_buffer() {
    const std::string name = stem_ + ".bin";
    const std::vector<unsigned char> data = std::exchange(model_.buffers[0].data, {0});
    result_.files.push_back({name, to_bytes({reinterpret_cast<const char*>(data.data()), data.size()})});
    const std::vector<std::byte> text = serialized();
    const auto* first = reinterpret_cast<const char*>(text.data());
    nlohmann::json json = nlohmann::json::parse(first, first + text.size());
    json["buffers"] = {{{"byteLength", data.size()}, {"uri", percent_encoded(name)}}};
    result_.files.push_back({stem_ + ".gltf", to_bytes(json.dump(2) + "\n")});
  }

  template <class T>
  int add_view(std::span<const T> values, int target) {
    std::vector<unsigned char>& data = model_.buffers[0].data;
    data.resize((data.size() + 3) / 4 * 4);
    if (values.size_bytes() >= kLargestBuffer - data.size()) {
      throw InputError(
          "the file would be over 2 GiB; ask for fewer cells, smaller images or one object at a time");
    }
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = values.size_bytes();
    view.target = target;
    const auto* first = reinterpret_cast<const unsigned char*>(values.data());
    data.insert(data.end(), first, first + values.size_bytes());
    model_.bufferViews.push_back(std::move(view));
    return static_cast<int>(model_.bufferViews.size()) - 1;
  }

  template <class T>
  int add_accessor(std::span<const T> values, int target, int component, int type, std::size_t count) {
    tinygltf::Accessor accessor;
    accessor.bufferView = add_view(values, target);
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = count;
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  template <glm::length_t D>
  int add_vertices(std::span<const glm::vec<D, float>> values) {
    return add_accessor(values, TINYGLTF_TARGET_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_FLOAT,
                        D == 2   ? TINYGLTF_TYPE_VEC2
                        : D == 3 ? TINYGLTF_TYPE_VEC3
                                 : TINYGLTF_TYPE_VEC4,
                        values.size());
  }

  int add_positions(std::span<const glm::vec3> positions) {
    glm::vec3 low = positions.front();
    glm::vec3 high = low;
    for (const glm::vec3& position : positions) {
      low = glm::min(low, position);
      high = glm::max(high, position);
    }
    const int accessor = add_vertices(positions);
    model_.accessors.back().minValues = {low.x, low.y, low.z};
    model_.accessors.back().maxValues = {high.x, high.y, high.z};
    return accessor;
  }

  int add_indices(std::span<const sweep::Triangle> triangles, std::size_t vertex_count) {
    const std::size_t count = 3 * triangles.size();
    if (vertex_count <= kMostShortVertices) {
      return add_accessor<std::uint16_t>(short_indices(triangles), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER,
                                         TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, count);
    }
    return add_accessor(triangles, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                        TINYGLTF_TYPE_SCALAR, count);
  }

  int add_image(const std::shared_ptr<const texmap::Image>& image, const std::string& name) {
    const std::shared_ptr<const std::vector<std::byte>> png = images_.png(image);
    tinygltf::Image entry;
    entry.name = name;
    if (is_binary_) {
      entry.mimeType = "image/png";
      entry.bufferView = add_view<std::byte>(*png, 0);
    } else {
      const std::string file = stem_ + "_" + std::to_string(model_.images.size()) + ".png";
      entry.uri = percent_encoded(file);
      result_.files.push_back({file, *png});
    }
    model_.images.push_back(std::move(entry));
    return static_cast<int>(model_.images.size()) - 1;
  }

  int add_texture(int image, texmap::Wrap wrap) {
    tinygltf::Sampler sampler;
    sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    static constexpr std::array kModes = {TINYGLTF_TEXTURE_WRAP_REPEAT, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE,
                                          TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT};  // by Wrap
    sampler.wrapS = sampler.wrapT = kModes[static_cast<std::size_t>(wrap)];
    const auto same = std::find(model_.samplers.begin(), model_.samplers.end(), sampler);
    tinygltf::Texture texture;
    texture.source = image;
    texture.sampler = static_cast<int>(same - model_.samplers.begin());
    if (same == model_.samplers.end()) model_.samplers.push_back(sampler);
    model_.textures.push_back(texture);
    return static_cast<int>(model_.textures.size()) - 1;
  }

  // An image is written once for all that use it.
  int image_texture(std::size_t index) {
    const auto found = image_textures_.find(index);
    if (found != image_textures_.end()) return found->second;
    const auto& [image, wrap, file] = std::get<texmap::ImageTexture>(scene_.textures[index]);
    return image_textures_[index] = add_texture(add_image(image, scene_.texture_names[index]), wrap);
  }

  // A procedural texture is written once for each object, as it lies on that surface.
  int baked_texture(const Object& object, const texmap::Procedural& procedural,
                    std::vector<texmap::UvTransform>& transforms) {
    if (texmap::repeats_in_unit_square(procedural)) {
      const StoredImage baked = images_.bake(procedural, options_.bake_size);
      if (baked.is_new) count_bake(*baked.image);
      return add_texture(add_image(baked.image, object.name), texmap::Wrap::kRepeat);
    }
    const MeshView& mesh = scene_.meshes[object.mesh];
    texmap::BakedTexture baked =
        bake_over(mesh, procedural, {.width = options_.bake_size, .height = options_.bake_size});
    transforms = std::move(baked.transforms);
    count_bake(baked.image);
    const auto image = std::make_shared<const texmap::Image>(std::move(baked.image));
    return add_texture(add_image(image, object.name), texmap::Wrap::kClamp);
  }

  void count_bake(const texmap::Image& image) {
    result_.ledger[Part::kBakes].calls += 1;
    result_.ledger[Part::kBakes].bytes += image.bytes();
  }

  // One for each material in use, and one more for each surface that a procedural texture is baked from.
  int add_material(const Object& object, std::vector<texmap::UvTransform>& transforms) {
    const Material material = object.material ? scene_.materials[*object.material] : Material{};
    const bool has_texture = material.texture && plan_.textures[*material.texture];
    const auto* procedural =
        has_texture ? std::get_if<texmap::Procedural>(&scene_.textures[*material.texture]) : nullptr;
    const bool is_baked = procedural != nullptr && plan_.needs_part(Part::kBakes);
    if (const auto found = materials_.find(object.material); !is_baked && found != materials_.end()) {
      return found->second;
    }
    const GltfMaterial terms = to_gltf(material);
    tinygltf::Material entry;
    entry.name = object.material ? material.name : "default";
    entry.doubleSided = true;  // a ray sees both sides of a surface
    tinygltf::PbrMetallicRoughness& pbr = entry.pbrMetallicRoughness;
    pbr.baseColorFactor = {terms.base_color.r, terms.base_color.g, terms.base_color.b, 1.0};
    pbr.metallicFactor = terms.metallic;
    pbr.roughnessFactor = terms.roughness;
    if (is_baked) {
      pbr.baseColorTexture.index = baked_texture(object, *procedural, transforms);
    } else if (has_texture && procedural == nullptr) {
      pbr.baseColorTexture.index = image_texture(*material.texture);
    }
    if (terms.specular_color) add_specular(entry, *terms.specular_color);
    model_.materials.push_back(std::move(entry));
    const int index = static_cast<int>(model_.materials.size()) - 1;
    if (!is_baked) materials_[object.material] = index;
    return index;
  }

  // Used, not required: a viewer that does not know it shows a dielectric's usual gloss.
  void add_specular(tinygltf::Material& material, float factor) {
    static const std::string kName = "KHR_materials_specular";
    const tinygltf::Value value(static_cast<double>(factor));
    const tinygltf::Value color(tinygltf::Value::Array{value, value, value});
    material.extensions[kName] = tinygltf::Value(tinygltf::Value::Object{{"specularColorFactor", color}});
    if (model_.extensionsUsed.empty()) model_.extensionsUsed.push_back(kName);
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
    primitive.indices = add_indices(mesh.triangles, mesh.positions.size());
    primitive.attributes["POSITION"] = add_positions(mesh.positions);
    primitive.attributes["NORMAL"] = add_vertices(mesh.normals);
    if (options_.has_tangents) {
      primitive.attributes["TANGENT"] = add_vertices(std::span<const glm::vec4>(
          sweep::find_tangents(mesh.positions, mesh.normals, mesh.texcoords, mesh.triangles)));
    }
    primitive.attributes["TEXCOORD_0"] =
        add_vertices(std::span<const glm::vec2>(gltf_texcoords(mesh, transforms)));
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

  const Scene& scene_;
  const Plan& plan_;
  const GltfOptions& options_;
  ImageStore own_images_;  // where the caller has none
  ImageStore& images_;
  std::string stem_;
  bool is_binary_;
  tinygltf::Model model_;
  GltfFile result_;
  std::map<std::size_t, int> image_textures_;
  std::map<std::optional<std::size_t>, int> materials_;  // by index; none: the default material
};

}  // namespace

GltfFile make_gltf(const Scene& scene, const Plan& plan, const std::filesystem::path& file,
                   const GltfOptions& options) {
  return Writer(scene, plan, file, options).write();
}

}  // namespace sweepkit::scene
