// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Thousands of drawings made by others (Material Design Icons, an npm package of tests/viewers), each swept
// along a helix: watertight, or refused with a reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "../sweep/mesh_measures.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/model.hpp"

namespace sweepkit::scene {
namespace {

std::vector<std::filesystem::path> icons() {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(SWEEPKIT_ICONS)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(SWEEPKIT_ICONS)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Icons, SweptAlongAHelixAreWatertightOrRefused) {
  const std::vector<std::filesystem::path> files = icons();
  if (files.empty()) {
    // .ci/run sets CI: there a test that cannot run has failed.
    ASSERT_EQ(std::getenv("CI"), nullptr) << "no icons in " SWEEPKIT_ICONS "; run scripts/setup";
    GTEST_SKIP() << "no icons in " SWEEPKIT_ICONS "; run scripts/setup";
  }
  std::size_t refused = 0;
  std::size_t faulty = 0;
  for (const std::filesystem::path& file : files) {
    // 24 units of a hundredth of a metre, about the helix or beside it as they are drawn.
    const std::string scene = R"({"sweepkit": 1, "objects": [{"name": "icon", "tessellation": {"contour": 160,
        "trajectory": 24}, "sweep": {"contour": {"svg": ")" +
                              file.filename().string() +
                              R"(", "scale": 0.01}, "trajectory": {"helix": {"radius": 1, "pitch": 0.5,
        "turns": 1}}}}]})";
    try {
      const Document document = parse_document(scene, file.parent_path() / "scene.json");
      const Model model = build(document, plan(document, {.product = Request::Product::kMeshFile}));
      const sweep::test::Measures m = sweep::test::measure(*model.meshes.front());
      // Where two outlines touch in a corner four sides meet along it: shared, and watertight all the same.
      if (m.leaking_edges == 0 && m.volume > 0 && m.worst_normal_length < 1e-6) continue;
      ++faulty;
      ADD_FAILURE() << file.filename() << ": " << m.leaking_edges << " open edges, volume " << m.volume;
    } catch (const InputError& error) {
      ++refused;
      std::printf("refused: %s\n", error.what());
    }
  }
  std::printf("%zu icons, %zu refused, %zu faulty\n", files.size(), refused, faulty);
  EXPECT_GT(files.size(), 5000u);
  EXPECT_LT(refused, files.size() / 100);
}

}  // namespace
}  // namespace sweepkit::scene
