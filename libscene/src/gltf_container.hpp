// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "gltf_view.hpp"

namespace sweepkit::scene {

/// How a model's buffer, its views and the extras join its JSON.
struct GltfContainer {
  std::span<const GltfView> views;
  std::string buffer_uri;  ///< percent-encoded; empty: the buffer is the .glb's own
  std::size_t buffer_bytes = 0;
  std::size_t unpacked_bytes = 0;  ///< of the second buffer, which packed views unpack into; 0: there is none
  std::string extras;              ///< JSON; empty: none
  bool is_indented = false;
};

/// The model as JSON text. tinygltf writes all but the buffers, which it would copy and put into the text as
/// base64, their views, whose extensions it would drop, and the extras, whose empty objects it would write as
/// null. Throws OutputError where it fails.
std::string gltf_json(tinygltf::Model& model, const GltfContainer& container);

/// What comes before the buffer in a .glb: header, the JSON padded with spaces, the buffer's own header.
std::vector<std::byte> glb_head(const std::string& json, std::size_t buffer_bytes);

}  // namespace sweepkit::scene
