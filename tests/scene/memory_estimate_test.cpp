// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/memory_estimate.hpp"

#include <gtest/gtest.h>

#include "scene_text.hpp"
#include "sweepkit/scene/model.hpp"

namespace sweepkit::scene {
namespace {

const std::string kTube =
    R"("sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0, 0, 0], [0, 1, 0]]}})";
const std::string kVase = R"("revolve": {"contour": {"bezier": [[0, -1], [1.3, -1], [1.3, 1], [0, 1]]}})";

std::string object(const std::string& name, const std::string& shape, const std::string& cells) {
  return R"({"name": ")" + name + R"(", "tessellation": )" + cells + ", " + shape + "}";
}

TEST(MemoryEstimate, IsWithinFivePercentOfWhatCountedShapesTake) {
  const std::string cells = R"({"contour": 100, "trajectory": 200})";
  const Document document =
      parse(scene_text("", object("tube", kTube, cells) + ", " + object("vase", kVase, cells) + ", " +
                               object("floor", R"("plane": {"size": [1, 1]})", cells)));
  const MemoryEstimate estimate = estimate_memory(document);
  const Model model = build(document, plan(document, {.product = Request::Product::kMeshFile}));
  double bytes = 3 * sizeof(Object);
  double triangles = 0;
  for (const auto& mesh : model.meshes) {
    bytes += static_cast<double>(mesh->bytes());
    triangles += static_cast<double>(mesh->triangles.size());
  }
  EXPECT_NEAR(static_cast<double>(estimate.bytes), bytes, 0.05 * bytes);
  EXPECT_NEAR(static_cast<double>(estimate.triangles), triangles, 0.05 * triangles);
  EXPECT_EQ(estimate.objects, 3u);
}

TEST(MemoryEstimate, CountsAPlacedPartTwiceSinceItIsCopied) {
  const auto bytes = [](const std::string& placement) {
    return estimate_memory(parse(scene_text("", R"({"name": "a", "parts": [{)" + placement + kTube + "}]}")))
        .bytes;
  };
  EXPECT_EQ(bytes(R"("translate": [1, 0, 0], )") - sizeof(Object), 2 * (bytes("") - sizeof(Object)));
}

TEST(MemoryEstimate, CountsTheTangentsOfWhatHasANormalMap) {
  const auto bytes = [](const std::string& map) {
    return estimate_memory(
               parse(scene_text(R"("textures": {"t": {"image": "t.png"}}, "materials": {"m": {)" + map + "}}",
                                R"({"name": "a", "material": "m", )" + kTube + "}")))
        .bytes;
  };
  EXPECT_EQ(bytes(R"("normal_map": "t")") - bytes(""), 16u * 65 * 65);
}

TEST(MemoryEstimate, OfAMillionInstancesHasOneMeshAndAMillionObjects) {
  Document document = parse(scene_text("", R"({"name": "a", )" + kTube + "}"));
  const std::uint64_t one = estimate_memory(document).bytes;
  document.objects[0].instances.resize(1000000);
  const MemoryEstimate estimate = estimate_memory(document);
  EXPECT_EQ(estimate.objects, 1000000u);
  EXPECT_EQ(estimate.triangles, 2u * 64 * 64);
  EXPECT_EQ(estimate.bytes - one, 999999 * sizeof(Object));
}

TEST(MemoryEstimate, OfAShapeByToleranceIsNothingAndOfAMeshFileMoreThanTheFile) {
  EXPECT_EQ(estimate_memory(parse(scene_text("", object("a", kTube, R"({"tolerance": 1e-5})")))).bytes,
            sizeof(Object));
  const Document file = parse_document(scene_text("", R"({"name": "knot", "mesh": {"file": "knot.obj"}})"),
                                       SWEEPKIT_SAMPLES "/meshes/s.json");
  EXPECT_GT(estimate_memory(file).bytes, std::filesystem::file_size(SWEEPKIT_SAMPLES "/meshes/knot.obj"));
  // One that is not there is told of when it is read.
  EXPECT_EQ(estimate_memory(parse(scene_text("", R"({"name": "a", "mesh": {"file": "none.obj"}})"))).bytes,
            sizeof(Object));
}

}  // namespace
}  // namespace sweepkit::scene
