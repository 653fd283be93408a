// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/gltf_size.hpp"

#include <gtest/gtest.h>

#include "scene_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

// 2^31 bytes at 12 a triangle and half of 32, or packed without (u,v) half of 24, a vertex.
TEST(GltfSize, AToleranceMayTakeAsManyTrianglesAsAFileHolds) {
  const std::string ball =
      R"({"name": "ball", "tessellation": {"tolerance": 0.1},
          "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}})";
  Document document = parse(scene_text("", ball));
  const auto most = [&](const GltfOptions& options) {
    document.objects[0].pieces[0].tessellation.most_triangles = 1'000'000'000;
    check_gltf_size(document, options);
    return document.objects[0].pieces[0].tessellation.most_triangles;
  };
  EXPECT_EQ(most({}), (std::uint64_t{1} << 31) / 28);
  EXPECT_EQ(most({.is_packed = true}), (std::uint64_t{1} << 32) / 24);
}

TEST(GltfSize, AnObjectOverTwoGibibytesIsRefusedByItsCellsAndAnotherBesideItIsNotCounted) {
  const auto rug = [](int cells) {
    return parse(scene_text("", R"({"name": "rug", "plane": {"size": [1, 1]}, "tessellation": {"contour": )" +
                                    std::to_string(cells) + R"(, "trajectory": 6000}}, )" + kFloor));
  };
  // 6000^2 cells take 32 + 24 bytes each, 1.88 GiB.
  Document fits = rug(6000);
  EXPECT_NO_THROW(check_gltf_size(fits, {}));
  Document large = rug(7000);
  EXPECT_THROW(check_gltf_size(large, {}), InputError);
  EXPECT_NO_THROW(check_gltf_size(large, {.is_quantized = true})) << "16 bytes a vertex";
}

}  // namespace
}  // namespace sweepkit::scene
