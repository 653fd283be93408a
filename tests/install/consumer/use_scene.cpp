// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A scene's text to a .glb: its header says how long it is, and its one mesh has the cells asked for.
#include <cstdio>
#include <cstring>

#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/model.hpp"

using namespace sweepkit;

int main() {
  const scene::Document document = scene::parse_document(
      R"({"sweepkit": 1, "objects": [{"name": "vase", "tessellation": {"contour": 8, "trajectory": 12},
          "revolve": {"contour": {"polyline": [[0.1, 0], [0.2, 0.3]]}}}]})",
      "vase.json");
  const scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kMeshFile});
  const scene::Model model = scene::build(document, plan);
  const scene::GltfFile gltf = scene::make_gltf(model.scene, plan, "vase.glb", {});
  const std::vector<std::byte>& bytes = gltf.files.back().bytes;
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 8, 4);
  const std::size_t triangles = model.scene.meshes[0].triangles.size();
  std::printf("scene: %zu triangles in %zu bytes\n", triangles, bytes.size());
  return std::memcmp(bytes.data(), "glTF", 4) == 0 && length == bytes.size() && triangles == 2 * 8 * 12 ? 0
                                                                                                        : 1;
}
