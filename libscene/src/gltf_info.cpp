// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A glTF file is looked at through the same JSON reader as a scene, so that what is wrong with it has a
// place. tinygltf is not asked: it would decode every image and load every buffer to count a few triangles.

#include "sweepkit/scene/gltf_info.hpp"

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
    for (const Node& node : array("materials")) info.materials.push_back(material(node));
    for (const Node& node : array("meshes")) info.meshes.push_back(mesh(node, info.materials));
    for (const Node& node : array("images")) info.images.push_back(image(node));
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
    if (error) return image;
    image.bytes = size;
    const std::string content = read_whole_file(file);
    set_size(image, std::as_bytes(std::span(content)));
    return image;
  }

  static void set_size(GltfInfo::Image& image, Bytes bytes) {
    const ImageHeader header = image_header(bytes).value_or(ImageHeader());
    image.width = header.width;
    image.height = header.height;
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
