// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The one file that knows tinygltf. A glTF is put together in memory - one buffer, its views and accessors,
// the images - and written to a stream: tinygltf's own file writing reports success for a full disk and a
// missing folder.

#include "sweepkit/scene/gltf.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>

#include "gltf_material.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/bake.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::scene {
namespace {

// byteOffset is an int in tinygltf, and glTF's .glb length field ends at 4 GiB.
constexpr std::size_t kLargestFile = std::size_t{1} << 31;

std::string percent_encoded(const std::string& name) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || std::strchr("-._~", c) != nullptr) {
      out += c;
    } else {
      out += '%';
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    }
  }
  return out;
}

class Writer {
 public:
  Writer(const Scene& scene, const std::filesystem::path& file, const GltfOptions& options)
      : scene_(scene),
        options_(options),
        stem_(file == "-" ? "scene" : file.stem().string()),
        is_binary_(file.extension() != ".gltf") {
    model_.asset.version = "2.0";
    model_.asset.generator = "sweepkit " SWEEPKIT_VERSION;
    model_.buffers.emplace_back();
  }

  GltfFile write() {
    tinygltf::Scene scene;
    scene.name = stem_;
    for (const Object& object : scene_.objects) {
      if (options_.object && object.name != *options_.object) continue;
      scene.nodes.push_back(static_cast<int>(model_.nodes.size()));
      add_object(object);
    }
    if (scene.nodes.empty()) {
      std::string names;
      for (const Object& object : scene_.objects) names += (names.empty() ? "" : ", ") + object.name;
      throw InputError("there is no object \"" + *options_.object + "\"; there is: " + names);
    }
    scene.nodes.push_back(static_cast<int>(model_.nodes.size()));
    add_camera();
    model_.scenes.push_back(std::move(scene));
    model_.defaultScene = 0;

    tinygltf::Buffer& buffer = model_.buffers[0];
    if (buffer.data.size() >= kLargestFile) {
      throw InputError("the file would be over 2 GiB; ask for fewer cells or write one --object at a time");
    }
    if (is_binary_) {
      while (buffer.data.size() % 4 != 0) buffer.data.push_back(0);
    } else {
      const std::string name = stem_ + ".bin";
      result_.files.push_back({name, to_bytes(buffer.data)});
      buffer.uri = percent_encoded(name);
    }
    std::ostringstream stream;
    if (is_binary_) {
      tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, stream, false, true);
      const std::string text = stream.str();
      result_.files.push_back({stem_ + ".glb", to_bytes(text)});
    } else {
      result_.files.push_back({stem_ + ".gltf", to_bytes(json_text())});
    }
    return std::move(result_);
  }

 private:
  template <class Bytes>
  static std::vector<std::byte> to_bytes(const Bytes& bytes) {
    std::vector<std::byte> out(bytes.size());
    std::memcpy(out.data(), bytes.data(), bytes.size());
    return out;
  }

  // tinygltf embeds a buffer as base64 when it writes to a stream; the text is written without the data and
  // the buffer's own name and length put in their place.
  std::string json_text();

  template <class T>
  int add_view(std::span<const T> values, int target) {
    std::vector<unsigned char>& data = model_.buffers[0].data;
    while (data.size() % 4 != 0) data.push_back(0);
    if (data.size() + values.size_bytes() >= kLargestFile) {
      throw InputError("the file would be over 2 GiB; ask for fewer cells or write one --object at a time");
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

  int add_accessor(int view, int component, int type, std::size_t count) {
    tinygltf::Accessor accessor;
    accessor.bufferView = view;
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = count;
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  int add_positions(std::span<const glm::vec3> positions) {
    glm::vec3 low = positions.front();
    glm::vec3 high = low;
    for (const glm::vec3& position : positions) {
      low = glm::min(low, position);
      high = glm::max(high, position);
    }
    const int accessor = add_accessor(add_view(positions, TINYGLTF_TARGET_ARRAY_BUFFER),
                                      TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, positions.size());
    model_.accessors.back().minValues = {low.x, low.y, low.z};
    model_.accessors.back().maxValues = {high.x, high.y, high.z};
    return accessor;
  }

  int add_indices(std::span<const sweep::Triangle> triangles, std::size_t vertex_count) {
    const std::size_t count = 3 * triangles.size();
    // 65535 is glTF's mark for a restart, so the largest index in 16 bits is 65534.
    if (vertex_count <= 65535) {
      std::vector<std::uint16_t> indices;
      indices.reserve(count);
      for (const sweep::Triangle& triangle : triangles) {
        for (const std::uint32_t index : triangle) indices.push_back(static_cast<std::uint16_t>(index));
      }
      const int view = add_view<std::uint16_t>(indices, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
      return add_accessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, count);
    }
    const std::span<const std::uint32_t> indices(triangles.front().data(), count);
    const int view = add_view(indices, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    return add_accessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, count);
  }

  // glTF's v runs down from the image's top row.
  int add_texcoords(const MeshView& mesh, const std::vector<texmap::UvTransform>& transforms) {
    std::vector<glm::vec2> texcoords(mesh.texcoords.begin(), mesh.texcoords.end());
    for (std::size_t area = 0; area < transforms.size(); ++area) {
      const auto& [scale, offset] = transforms[area];
      if (scale == glm::dvec2(1.0) && offset == glm::dvec2(0.0)) continue;
      const sweep::Area& stretch = mesh.areas[area];
      // No vertex belongs to two areas, but to several triangles: each is taken from the mesh's own (u,v).
      for (std::uint32_t t = 0; t < stretch.triangle_count; ++t) {
        for (const std::uint32_t v : mesh.triangles[stretch.first_triangle + t]) {
          texcoords[v] = glm::vec2(offset + scale * glm::dvec2(mesh.texcoords[v]));
        }
      }
    }
    for (glm::vec2& uv : texcoords) uv.y = 1 - uv.y;
    return add_accessor(add_view<glm::vec2>(texcoords, TINYGLTF_TARGET_ARRAY_BUFFER),
                        TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, texcoords.size());
  }

  int add_image(const texmap::Image& image, const std::string& name) {
    const std::vector<std::byte> png = texmap::encode_image(image, texmap::ImageFormat::kPng);
    tinygltf::Image entry;
    entry.name = name;
    if (is_binary_) {
      entry.mimeType = "image/png";
      entry.bufferView = add_view<std::byte>(png, 0);
    } else {
      const std::string file = stem_ + "_" + std::to_string(model_.images.size()) + ".png";
      entry.uri = percent_encoded(file);
      result_.files.push_back({file, png});
    }
    model_.images.push_back(std::move(entry));
    return static_cast<int>(model_.images.size()) - 1;
  }

  int add_texture(int image, texmap::Wrap wrap) {
    tinygltf::Sampler sampler;
    sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    sampler.wrapS = sampler.wrapT =
        wrap == texmap::Wrap::kRepeat ? TINYGLTF_TEXTURE_WRAP_REPEAT : TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    const auto same = std::find(model_.samplers.begin(), model_.samplers.end(), sampler);
    tinygltf::Texture texture;
    texture.source = image;
    texture.sampler = static_cast<int>(same - model_.samplers.begin());
    if (same == model_.samplers.end()) model_.samplers.push_back(sampler);
    model_.textures.push_back(texture);
    return static_cast<int>(model_.textures.size()) - 1;
  }

  // The image textures of a scene are written once; a procedural one once for each object, as it lies on that
  // surface.
  int image_texture(std::size_t index) {
    const auto found = image_textures_.find(index);
    if (found != image_textures_.end()) return found->second;
    const auto& [image, wrap] = std::get<texmap::ImageTexture>(scene_.textures[index]);
    return image_textures_[index] = add_texture(add_image(*image, scene_.texture_names[index]), wrap);
  }

  int baked_texture(const Object& object, const texmap::Procedural& procedural,
                    std::vector<texmap::UvTransform>& transforms) {
    const MeshView& mesh = scene_.meshes[object.mesh];
    std::vector<std::uint32_t> area_ends;
    for (const sweep::Area& area : mesh.areas) area_ends.push_back(area.first_triangle + area.triangle_count);
    texmap::BakedTexture baked =
        texmap::bake(procedural, {mesh.positions, mesh.texcoords, mesh.triangles, area_ends, mesh.origin},
                     {options_.bake_size, options_.bake_size});
    transforms = std::move(baked.transforms);
    result_.ledger[Part::kBakes].calls += 1;
    result_.ledger[Part::kBakes].bytes += baked.image.bytes();
    const bool repeats = texmap::repeats_in_unit_square(procedural);
    return add_texture(add_image(baked.image, object.name),
                       repeats ? texmap::Wrap::kRepeat : texmap::Wrap::kClamp);
  }

  int add_material(const Object& object, std::vector<texmap::UvTransform>& transforms) {
    const Material material = object.material ? scene_.materials[*object.material] : Material{};
    const texmap::Procedural* procedural =
        material.texture ? std::get_if<texmap::Procedural>(&scene_.textures[*material.texture]) : nullptr;
    const bool is_shared = object.material && procedural == nullptr;
    if (is_shared) {
      const auto found = materials_.find(*object.material);
      if (found != materials_.end()) return found->second;
    }
    const GltfMaterial terms = to_gltf(material);
    tinygltf::Material entry;
    entry.name = object.material ? material.name : "default";
    // A ray sees both sides of a surface.
    entry.doubleSided = true;
    tinygltf::PbrMetallicRoughness& pbr = entry.pbrMetallicRoughness;
    pbr.baseColorFactor = {terms.base_color.r, terms.base_color.g, terms.base_color.b, 1.0};
    pbr.metallicFactor = terms.metallic;
    pbr.roughnessFactor = terms.roughness;
    if (material.texture) {
      pbr.baseColorTexture.index = procedural != nullptr ? baked_texture(object, *procedural, transforms)
                                                         : image_texture(*material.texture);
    }
    model_.materials.push_back(std::move(entry));
    const int index = static_cast<int>(model_.materials.size()) - 1;
    if (is_shared) materials_[*object.material] = index;
    return index;
  }

  void add_object(const Object& object) {
    const MeshView& mesh = scene_.meshes[object.mesh];
    if (mesh.triangles.empty()) throw InputError("the object \"" + object.name + "\" has no triangles");
    std::vector<texmap::UvTransform> transforms;
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = add_material(object, transforms);
    primitive.indices = add_indices(mesh.triangles, mesh.positions.size());
    primitive.attributes["POSITION"] = add_positions(mesh.positions);
    primitive.attributes["NORMAL"] =
        add_accessor(add_view(mesh.normals, TINYGLTF_TARGET_ARRAY_BUFFER), TINYGLTF_COMPONENT_TYPE_FLOAT,
                     TINYGLTF_TYPE_VEC3, mesh.normals.size());
    primitive.attributes["TEXCOORD_0"] = add_texcoords(mesh, transforms);
    tinygltf::Mesh entry;
    entry.name = object.name;
    entry.primitives.push_back(std::move(primitive));
    tinygltf::Node node;
    node.name = object.name;
    node.mesh = static_cast<int>(model_.meshes.size());
    const glm::dmat4 matrix = object.world_from_object * translation(mesh.origin);
    if (matrix != glm::dmat4(1.0)) set_matrix(node, matrix);
    model_.meshes.push_back(std::move(entry));
    model_.nodes.push_back(std::move(node));
  }

  static glm::dmat4 translation(const glm::dvec3& by) {
    glm::dmat4 matrix(1.0);
    matrix[3] = glm::dvec4(by, 1);
    return matrix;
  }

  static void set_matrix(tinygltf::Node& node, const glm::dmat4& matrix) {
    const glm::dmat3 linear(matrix);
    if (linear == glm::dmat3(1.0)) {
      node.translation = {matrix[3].x, matrix[3].y, matrix[3].z};
      return;
    }
    for (glm::length_t column = 0; column < 4; ++column) {
      for (glm::length_t row = 0; row < 4; ++row) node.matrix.push_back(matrix[column][row]);
    }
  }

  void add_camera() {
    const Camera& from = scene_.camera;
    tinygltf::Camera camera;
    camera.type = "perspective";
    camera.name = "camera";
    camera.perspective.yfov = from.fov_deg * (3.14159265358979323846 / 180);
    camera.perspective.aspectRatio = static_cast<double>(scene_.width) / scene_.height;
    const double distance = glm::length(from.target - from.eye);
    camera.perspective.znear = 1e-3 * distance;
    camera.perspective.zfar = 1e3 * distance;
    model_.cameras.push_back(camera);
    const glm::dvec3 back = glm::normalize(from.eye - from.target);
    glm::dvec3 right = glm::cross(from.up, back);
    // Looking along `up`, any right will do.
    if (glm::length(right) < 1e-9 * glm::length(from.up))
      right = glm::cross(glm::dvec3(0, 0, -1), back) + glm::dvec3(1e-3, 0, 0);
    right = glm::normalize(right - glm::dot(right, back) * back);
    tinygltf::Node node;
    node.name = "camera";
    node.camera = 0;
    set_matrix(node, {glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0),
                      glm::dvec4(from.eye, 1)});
    model_.nodes.push_back(std::move(node));
  }

  const Scene& scene_;
  const GltfOptions& options_;
  std::string stem_;
  bool is_binary_;
  tinygltf::Model model_;
  GltfFile result_;
  std::map<std::size_t, int> image_textures_;
  std::map<std::size_t, int> materials_;
};

std::string Writer::json_text() {
  tinygltf::Buffer& buffer = model_.buffers[0];
  const std::size_t length = buffer.data.size();
  const std::string uri = buffer.uri;
  // One byte stands in for the data while tinygltf writes; its base64 text is then replaced.
  buffer.data.assign(1, 0);
  buffer.uri.clear();
  std::ostringstream stream;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, stream, true, false);
  std::string text = stream.str();
  const std::string stand_in = "\"byteLength\": 1,";
  const std::size_t length_at = text.find(stand_in, text.find("\"buffers\""));
  const std::size_t uri_at = text.find("\"uri\": \"data:", length_at);
  const std::size_t uri_end = text.find('"', text.find("data:", uri_at));
  if (length_at == std::string::npos || uri_at == std::string::npos)
    throw OutputError("tinygltf wrote a buffer in another form");
  text.replace(uri_at, uri_end + 1 - uri_at, "\"uri\": \"" + uri + "\"");
  text.replace(length_at, stand_in.size(), "\"byteLength\": " + std::to_string(length) + ",");
  return text;
}

}  // namespace

GltfFile make_gltf(const Scene& scene, const Plan&, const std::filesystem::path& file,
                   const GltfOptions& options) {
  return Writer(scene, file, options).write();
}

}  // namespace sweepkit::scene
