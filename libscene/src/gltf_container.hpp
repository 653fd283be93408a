// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <string>
#include <vector>

namespace sweepkit::scene {

/// How a model's buffer and extras join its JSON.
struct GltfContainer {
  std::string buffer_uri;  ///< percent-encoded; empty: the buffer is the .glb's own
  std::size_t buffer_bytes = 0;
  std::string extras;  ///< JSON; empty: none
  bool is_indented = false;
};

/// The model as JSON text. tinygltf writes all but the buffer, which it would copy and put into the text as
/// base64, and the extras, whose empty objects it would write as null. Throws OutputError where it fails.
std::string gltf_json(tinygltf::Model& model, const GltfContainer& container);

/// The .glb: header, the JSON padded with spaces, the buffer padded with zeros.
std::vector<std::byte> glb_bytes(const std::string& json, std::vector<std::byte> buffer);

}  // namespace sweepkit::scene
