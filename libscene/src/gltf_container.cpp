// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// tinygltf's own file writing reports success for a full disk and a missing folder, and writes no images; its
// binary writing copies the buffer twice. So it writes JSON to a stream, and the container is made here.

#include "gltf_container.hpp"

#include <optional>
#include <sstream>

#include "sweepkit/error.hpp"

namespace sweepkit::scene {

namespace {

std::string view_json(const GltfView& view) {
  const auto member = [](const char* key, std::size_t value) {
    return value > 0 ? std::string(",\"") + key + "\":" + std::to_string(value) : std::string();
  };
  const std::optional<GltfPacking>& packing = view.packing;
  std::string json = packing ? R"({"buffer":1)" : R"({"buffer":0)";
  json += member("byteLength", packing ? packing->count * packing->item_bytes : view.length);
  json += member("byteOffset", packing ? packing->unpacked_offset : view.offset);
  json += member("byteStride", view.stride);
  json += member("target", static_cast<std::size_t>(view.target));
  if (packing) {
    json += R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0)" + member("byteLength", view.length) +
            member("byteOffset", view.offset) + member("byteStride", packing->item_bytes) +
            member("count", packing->count) + R"(,"mode":")" + packing->mode + '"';
    if (!packing->filter.empty()) json += R"(,"filter":")" + packing->filter + '"';
    json += "}}";
  }
  return json + '}';
}

}  // namespace

std::string gltf_json(tinygltf::Model& model, const GltfContainer& container) {
  std::ostringstream stream;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, container.is_indented, false)) {
    throw OutputError("the glTF could not be written");
  }
  std::string json = std::move(stream).str();
  json.resize(json.find_last_of('}'));
  while (json.back() == '\n' || json.back() == ' ') json.pop_back();
  const auto add = [&](const char* key, const std::string& value) {
    if (json.back() != '{') json += ',';
    json += container.is_indented ? "\n  " : "";
    json += std::string("\"") + key + "\":" + (container.is_indented ? " " : "") + value;
  };
  std::string views;
  for (const GltfView& view : container.views) {
    if (!views.empty()) views += ',';
    views += (container.is_indented ? "\n    " : "") + view_json(view);
  }
  add("bufferViews", '[' + views + (container.is_indented ? "\n  ]" : "]"));
  std::string buffers = R"([{"byteLength":)" + std::to_string(container.buffer_bytes);
  if (!container.buffer_uri.empty()) buffers += R"(,"uri":")" + container.buffer_uri + '"';
  buffers += '}';
  if (container.unpacked_bytes > 0) {
    buffers += R"(,{"byteLength":)" + std::to_string(container.unpacked_bytes) +
               R"(,"extensions":{"EXT_meshopt_compression":{"fallback":true}}})";
  }
  add("buffers", buffers + ']');
  if (!container.extras.empty()) add("extras", container.extras);
  json += container.is_indented ? "\n}\n" : "}";
  return json;
}

std::vector<std::byte> glb_head(const std::string& json, std::size_t buffer_bytes) {
  const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
  const std::size_t json_size = padded(json.size());
  const std::size_t buffer_size = padded(buffer_bytes);
  const std::size_t whole = 12 + 8 + json_size + 8 + buffer_size;
  if (whole > 0xFFFFFFFFu) {
    throw InputError("the file would be over 4 GiB, more than a .glb counts; ask for fewer objects or cells");
  }
  std::vector<std::byte> out;
  out.reserve(28 + json_size);
  const auto word = [&](std::size_t value) {
    for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::byte>((value >> (8 * i)) & 0xFF));
  };
  word(0x46546C67);  // "glTF"
  word(2);
  word(whole);
  word(json_size);
  word(0x4E4F534A);  // "JSON"
  const auto* text = reinterpret_cast<const std::byte*>(json.data());
  out.insert(out.end(), text, text + json.size());
  out.resize(20 + json_size, std::byte{' '});
  word(buffer_size);
  word(0x004E4942);  // "BIN"
  return out;
}

}  // namespace sweepkit::scene
