// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A glTF file is looked at through the same JSON reader as a scene, so that what is wrong with it has a
// place. tinygltf is not asked: it would decode every image and load every buffer to count a few triangles.

#include "sweepkit/scene/gltf_info.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <span>

#include "gltf_file.hpp"
#include "image_header.hpp"
#include "object_reader.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

using Bytes = std::span<const std::byte>;

constexpr double kMostIndex = 4294967295.0;

// The arrays of a glTF file point at one another by index.
class Reader {
 public:
  Reader(const Node& root, const std::filesystem::path& folder, Bytes binary)
      : root_(ObjectReader(root)), folder_(folder), binary_(binary) {}

  GltfInfo read() {
    GltfInfo info;
    ObjectReader asset(root_.get("asset"));
    const Node version = asset.get("version");
    if (version.text().compare(0, 2, "2.") != 0)
      version.fail("needs glTF 2.x, got \"" + version.text() + "\"");
    if (const auto generator = asset.find("generator")) info.generator = generator->text();
    if (const auto copyright = asset.find("copyright")) info.copyright = copyright->text();
    info.extensions_used = names("extensionsUsed");
    info.extensions_required = names("extensionsRequired");
    info.has_scene = has_scene();
    for (const Node& node : array("buffers")) info.buffers.push_back(buffer(node));
    for (const Node& node : array("bufferViews")) add_packed(node, info.packed);
    for (const Node& node : array("cameras")) {
      ObjectReader reader(node);
      info.cameras.push_back({name_of(reader), reader.get("type").text()});
    }
    for (const Node& node : lights()) {
      ObjectReader reader(node);
      const std::optional<Node> intensity = reader.find("intensity");
      info.lights.push_back(
          {name_of(reader), reader.get("type").text(), intensity ? intensity->number() : 1.0});
    }
    for (const Node& node : array("animations")) info.animations.push_back(animation(node));
    for (const Node& node : array("materials")) info.materials.push_back(material(node));
    for (const Node& node : array("meshes")) info.meshes.push_back(mesh(node, info.materials));
    for (const Node& node : array("images")) info.images.push_back(image(node));
    for (const Node& node : array("textures")) info.textures.push_back(texture(node, info.images));
    return info;
  }

 private:
  std::vector<Node> array(const std::string& key) {
    const std::optional<Node> node = root_.find(key);
    return node ? node->items() : std::vector<Node>();
  }

  static std::string name_of(ObjectReader& reader) {
    const std::optional<Node> name = reader.find("name");
    return name ? name->text() : "";
  }

  static std::uint64_t whole(const Node& node) {
    return static_cast<std::uint64_t>(node.number({.low = 0, .high = kMostIndex}));
  }

  Node pointed(const Node& index, const std::string& key) {
    const std::vector<Node> items = array(key);
    const std::uint64_t at = whole(index);
    if (at >= items.size()) {
      index.fail("points at " + key + " " + std::to_string(at) + ", but there are " +
                 std::to_string(items.size()));
    }
    return items[at];
  }

  std::vector<std::string> names(const std::string& key) {
    std::vector<std::string> texts;
    for (const Node& node : array(key)) texts.push_back(node.text());
    return texts;
  }

  // What is there, if all on the way is an object: of other programs' extras anything may be.
  static std::optional<Node> inner(std::optional<Node> node, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
      if (!node || !node->is_object()) return std::nullopt;
      node = ObjectReader(*node).find(key);
    }
    return node;
  }

  bool has_scene() { return inner(root_.find("extras"), {"sweepkit", "scene"}).has_value(); }

  std::vector<Node> lights() {
    const std::optional<Node> node = inner(root_.find("extensions"), {"KHR_lights_punctual", "lights"});
    return node ? node->items() : std::vector<Node>();
  }

  GltfInfo::Buffer buffer(const Node& node) {
    ObjectReader reader(node);
    GltfInfo::Buffer buffer;
    buffer.bytes = whole(reader.get("byteLength"));
    const std::optional<Node> uri = reader.find("uri");
    if (!uri || uri->text().compare(0, 5, "data:") == 0) return buffer;
    buffer.file = uri->text();
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(folder_ / percent_decoded(buffer.file), error);
    buffer.is_missing = error || size < buffer.bytes;
    return buffer;
  }

  static void add_packed(const Node& node, GltfInfo::Packed& packed) {
    ObjectReader view(node);
    const std::optional<Node> extension = inner(view.find("extensions"), {"EXT_meshopt_compression"});
    if (!extension) return;
    packed.views += 1;
    packed.bytes += whole(ObjectReader(*extension).get("byteLength"));
    packed.unpacked_bytes += whole(view.get("byteLength"));
  }

  GltfInfo::Animation animation(const Node& node) {
    ObjectReader reader(node);
    GltfInfo::Animation animation{name_of(reader)};
    animation.channels = reader.get("channels").items().size();
    for (const Node& sampler : reader.get("samplers").items()) {
      ObjectReader input(pointed(ObjectReader(sampler).get("input"), "accessors"));
      if (const std::optional<Node> most = input.find("max")) {
        for (const Node& seconds : most->items())
          animation.seconds = std::max(animation.seconds, seconds.number());
      }
    }
    return animation;
  }

  GltfInfo::Texture texture(const Node& node, const std::vector<GltfInfo::Image>& images) {
    ObjectReader reader(node);
    GltfInfo::Texture texture{name_of(reader), {}};
    if (const std::optional<Node> source = reader.find("source")) {
      pointed(*source, "images");
      const std::uint64_t index = whole(*source);
      texture.image = images[index].name.empty() ? std::to_string(index) : images[index].name;
    }
    return texture;
  }

  std::uint64_t bytes(const Node& accessor_index) {
    ObjectReader accessor(pointed(accessor_index, "accessors"));
    const std::uint64_t component = whole(accessor.get("componentType"));
    const std::uint64_t size = component < 5122 ? 1 : component < 5125 ? 2 : 4;
    static const std::vector<std::string> kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    static constexpr std::uint64_t kComponents[] = {1, 2, 3, 4, 4, 9, 16};
    return size * kComponents[accessor.get("type").choice(kTypes)] * whole(accessor.get("count"));
  }

  // Of all that the vertices have; the members are attributes, of whatever program.
  std::uint64_t attribute_bytes(const Node& attributes) {
    std::uint64_t sum = 0;
    ObjectReader reader(attributes);
    for (const auto& member : std::get<JsonValue::Object>(attributes.value().data))
      sum += bytes(reader.get(member.key));
    return sum;
  }

  std::uint64_t count(const Node& accessor_index) {
    ObjectReader accessor(pointed(accessor_index, "accessors"));
    return whole(accessor.get("count"));
  }

  static GltfInfo::Material material(const Node& node) {
    ObjectReader reader(node);
    GltfInfo::Material material{name_of(reader)};
    if (const auto pbr = reader.find("pbrMetallicRoughness")) {
      material.is_textured = ObjectReader(*pbr).find("baseColorTexture").has_value();
    }
    return material;
  }

  GltfInfo::Mesh mesh(const Node& node, const std::vector<GltfInfo::Material>& materials) {
    ObjectReader reader(node);
    GltfInfo::Mesh mesh{name_of(reader)};
    bool is_first = true;
    for (const Node& item : reader.get("primitives").items()) {
      ObjectReader primitive(item);
      const std::optional<Node> mode = primitive.find("mode");
      const std::optional<Node> indices = primitive.find("indices");
      const std::uint64_t vertices = count(ObjectReader(primitive.get("attributes")).get("POSITION"));
      const std::uint64_t corners = indices ? count(*indices) : vertices;
      const std::uint64_t kind = mode ? whole(*mode) : 4;
      if (kind == 4) mesh.triangles += corners / 3;
      if ((kind == 5 || kind == 6) && corners > 2) mesh.triangles += corners - 2;  // a strip, a fan
      mesh.vertices += vertices;
      mesh.vertex_bytes += attribute_bytes(primitive.get("attributes"));
      if (indices) mesh.index_bytes += bytes(*indices);
      if (const auto targets = primitive.find("targets")) {
        const std::vector<Node> all = targets->items();
        mesh.targets = all.size();
        for (const Node& target : all) mesh.vertex_bytes += attribute_bytes(target);
      }
      if (const auto material = primitive.find("material"); material && is_first) {
        pointed(*material, "materials");
        mesh.material = materials[whole(*material)].name;
      }
      is_first = false;
    }
    return mesh;
  }

  GltfInfo::Image image(const Node& node) {
    ObjectReader reader(node);
    GltfInfo::Image image{name_of(reader), {}};
    if (const auto type = reader.find("mimeType")) {
      image.format = type->text().compare(0, 6, "image/") == 0 ? type->text().substr(6) : type->text();
    }
    if (const auto view_index = reader.find("bufferView")) {
      ObjectReader view(pointed(*view_index, "bufferViews"));
      const std::optional<Node> offset = view.find("byteOffset");
      const std::uint64_t start = offset ? whole(*offset) : 0;
      const Node length = view.get("byteLength");
      image.bytes = whole(length);
      if (start <= binary_.size() && image.bytes <= binary_.size() - start) {
        set_size(image, binary_.subspan(start, image.bytes));
      } else if (!binary_.empty()) {
        length.fail("reaches past the end of the binary chunk");
      }
      return image;
    }
    const std::string uri = reader.get("uri").text();
    if (uri.compare(0, 5, "data:") == 0) {
      image.bytes = (uri.size() - uri.find(',') - 1) / 4 * 3;  // base64, give or take its padding
      return image;
    }
    image.file = uri;
    std::error_code error;
    const std::filesystem::path file = folder_ / percent_decoded(uri);
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    image.is_missing = static_cast<bool>(error);
    if (error) return image;
    image.bytes = size;
    const std::string content = read_whole_file(file);
    set_size(image, std::as_bytes(std::span(content)));
    return image;
  }

  static void set_size(GltfInfo::Image& image, Bytes bytes) {
    const std::optional<ImageHeader> header = image_header(bytes);
    if (!header) return;
    image.width = header->width;
    image.height = header->height;
    image.format = header->is_jpeg ? "jpeg" : "png";
  }

  static std::string percent_decoded(const std::string& uri) {
    std::string out;
    for (std::size_t i = 0; i < uri.size(); ++i) {
      unsigned int code = 0;
      const std::string digits = uri.substr(i, 3);
      if (digits.size() == 3 && std::sscanf(digits.c_str(), "%%%2x", &code) == 1) {
        out += static_cast<char>(code);
        i += 2;
      } else {
        out += uri[i];
      }
    }
    return out;
  }

  ObjectReader root_;
  std::filesystem::path folder_;
  Bytes binary_;
};

}  // namespace

GltfInfo read_gltf_info(const std::filesystem::path& file) {
  std::string content = read_whole_file(file);
  const std::size_t bytes = content.size();
  const GltfChunks container = split_gltf(std::move(content), file.string());
  const JsonDocument json = parse_json(container.json, file.string());
  const Bytes binary = std::as_bytes(std::span(container.binary));
  GltfInfo info = Reader(Node(json.root, ""), file.parent_path(), binary).read();
  info.bytes = bytes;
  return info;
}

}  // namespace sweepkit::scene
