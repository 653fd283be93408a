// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "scene_text.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/model.hpp"

// A written glTF, read back by hand.
namespace sweepkit::scene {

using nlohmann::json;

struct Parsed {
  json root;
  std::vector<std::byte> buffer;
  GltfFile file;

  const std::byte* view(std::size_t index) const {
    return buffer.data() + root["bufferViews"][index].value("byteOffset", std::size_t{0});
  }
  template <class T>
  std::vector<T> accessor(std::size_t index) const {
    const json& accessor = root["accessors"][index];
    const std::size_t per = accessor["type"] == "SCALAR" ? 1 : accessor["type"] == "VEC2" ? 2 : 3;
    std::vector<T> values(accessor["count"].get<std::size_t>() * per);
    std::memcpy(values.data(), view(accessor["bufferView"]), values.size() * sizeof(T));
    return values;
  }
  const json& primitive(std::size_t mesh = 0) const { return root["meshes"][mesh]["primitives"][0]; }
};

inline std::uint32_t word(const std::vector<std::byte>& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

inline GltfFile make(const Model& model, const Document& document, const std::filesystem::path& file,
                     const GltfOptions& options = {.bake_size = 32}) {
  return make_gltf(model.scene, plan(document, {.product = Request::Product::kMeshFile}), file, options);
}

inline GltfFile make(const std::string& text, const std::filesystem::path& file,
                     const GltfOptions& options = {.bake_size = 32}) {
  const Document document = parse_document(text, SWEEPKIT_SAMPLES "/scenes/s.json");
  return make(build(document, plan(document, {.product = Request::Product::kMeshFile})), document, file,
              options);
}

inline Parsed glb(const std::string& text, const GltfOptions& options = {.bake_size = 32}) {
  Parsed parsed;
  parsed.file = make(text, "out.glb", options);
  EXPECT_EQ(parsed.file.files.size(), 1u);
  const std::vector<std::byte>& bytes = parsed.file.files.back().bytes;
  EXPECT_EQ(word(bytes, 0), 0x46546C67u) << "glTF";
  EXPECT_EQ(word(bytes, 4), 2u);
  EXPECT_EQ(word(bytes, 8), bytes.size());
  const std::size_t json_size = word(bytes, 12);
  EXPECT_EQ(word(bytes, 16), 0x4E4F534Au) << "JSON";
  EXPECT_EQ(json_size % 4, 0u);
  const auto* text_at = reinterpret_cast<const char*>(bytes.data() + 20);
  parsed.root = json::parse(text_at, text_at + json_size);
  const std::size_t binary_at = 20 + json_size;
  EXPECT_EQ(word(bytes, binary_at + 4), 0x004E4942u) << "BIN";
  EXPECT_EQ(word(bytes, binary_at), bytes.size() - binary_at - 8);
  EXPECT_EQ(bytes.size() % 4, 0u);
  parsed.buffer.assign(bytes.begin() + static_cast<std::ptrdiff_t>(binary_at) + 8, bytes.end());
  return parsed;
}

inline const std::string kVase =
    R"({"name": "vase", "material": "m", "tessellation": {"contour": 10, "trajectory": 12},
        "revolve": {"contour": {"bezier": [[0, 0], [0.1, 0], [0.1, 0.2]]}}})";

}  // namespace sweepkit::scene
