// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on the glTF extension MSFT_lod (Microsoft), which has the shares in the node's extras, one a level.

#include "gltf_levels.hpp"

#include <numbers>

#include "gltf_number.hpp"

namespace sweepkit::scene {
namespace {

// Of a picture of 16:9, that a ball as high as `height` of it covers.
double coverage(double height) {
  return std::numbers::pi / 4 * height * height * 9 / 16;
}

}  // namespace

void point_at_levels(tinygltf::Model& model, std::size_t node, std::span<const CoarserMesh> levels) {
  tinygltf::Value::Array ids;
  tinygltf::Value::Array shares;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    ids.emplace_back(static_cast<int>(node + i));
    // A level is shown until the next one may be.
    shares.emplace_back(in_few_digits(static_cast<float>(coverage(levels[i].height))));
  }
  shares.emplace_back(0.0);
  tinygltf::Node& entry = model.nodes[node];
  entry.extensions[kLevelsExtension] = tinygltf::Value({{"ids", tinygltf::Value(std::move(ids))}});
  entry.extras = tinygltf::Value({{"MSFT_screencoverage", tinygltf::Value(std::move(shares))}});
}

}  // namespace sweepkit::scene
