// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A textured vase seen from its seam, before and after: filtered over the neighbours' hits as they are, so
// that a pixel beside the seam averages the whole way round, and with each neighbour at its nearest
// representative. Prints the error of the columns at the seam over that of the columns beside them.
//
// Usage: seam [FOLDER]   writes seam_before.png and seam_after.png

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/texmap/image_error.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace {

using namespace sweepkit;

constexpr int kWidth = 320;
constexpr int kHeight = 420;

// The vase of samples/scenes/vase_and_cup.json, turned so that its seam faces the camera.
const char* const kScene = R"({"sweepkit": 1,
  "camera": {"eye": [1.5, 0.34, 0], "target": [0, 0.208, 0], "fov_deg": 17, "width": 320, "height": 420},
  "background": [0.75, 0.78, 0.8], "ambient": [0.35, 0.35, 0.35],
  "lights": [{"directional": [-0.8, -0.5, -0.4], "intensity": [0.75, 0.75, 0.75]}],
  "textures": {"glaze": {"procedural": "checker"}},
  "materials": {"vase": {"diffuse": [1, 1, 1], "texture": "glaze"}},
  "objects": [{"name": "vase", "material": "vase", "tessellation": {"contour": 46, "trajectory": 80},
    "revolve": {"contour": {"beziers": [
      [[0, 0], [0.064, 0]],
      [[0.064, 0], [0.073, 0], [0.076, 0.006], [0.070, 0.013]],
      [[0.070, 0.013], [0.055, 0.0305], [0.156, 0.090], [0.151, 0.195]],
      [[0.151, 0.195], [0.1465, 0.285], [0.056, 0.275], [0.052, 0.345]],
      [[0.052, 0.345], [0.0497, 0.385], [0.068, 0.402], [0.090, 0.417]]]}}}]})";

// Lozenges of clay and cream with a fine dark line about each, the same all round.
std::shared_ptr<const texmap::Image> glaze() {
  constexpr int kSize = 1024;
  const glm::vec3 clay(0.45f, 0.13f, 0.06f);
  const glm::vec3 cream(0.85f, 0.78f, 0.6f);
  const glm::vec3 line(0.04f, 0.05f, 0.08f);
  texmap::Image image{kSize, kSize, 3, std::vector<std::uint16_t>(3 * kSize * kSize)};
  auto texel = std::get<std::vector<std::uint16_t>>(image.texels).begin();
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double p = 12.0 * (x + y) / kSize;
      const double q = 12.0 * (x - y) / kSize;
      const bool is_line = std::abs(p - std::round(p)) < 0.09 || std::abs(q - std::round(q)) < 0.09;
      const bool is_clay = static_cast<int>(std::floor(p) + std::floor(q)) % 2 != 0;
      const glm::vec3 color = is_line ? line : is_clay ? clay : cream;
      for (int k = 0; k < 3; ++k) *texel++ = static_cast<std::uint16_t>(std::lround(65535 * color[k]));
    }
  }
  return std::make_shared<const texmap::Image>(std::move(image));
}

struct Vase {
  scene::Document document = scene::parse_document(kScene, "seam");
  scene::Model model;

  explicit Vase(const std::shared_ptr<const texmap::Image>& image) {
    model = scene::build(document, scene::plan(document, {}));
    model.scene.textures[0] = texmap::ImageTexture{image};
    document.textures[0].source = scene::ImageEntry{};
  }
  texmap::Image draw(const render::Options& options) const {
    const scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kPicture,
                                                    .filter = options.filter,
                                                    .is_supersampled = options.supersampling > 1});
    return render::render(model.scene, plan, options).image;
  }
};

void write(const std::filesystem::path& file, const texmap::Image& image) {
  const std::vector<std::byte> bytes = texmap::encode_image(image, texmap::ImageFormat::kPng);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void report(const char* name, const texmap::Image& image, const texmap::Image& reference) {
  const auto columns = [&](int first, int width) {
    return texmap::rmse(image, reference, {first, 60, width, kHeight - 120});
  };
  const double seam = columns(kWidth / 2 - 2, 4);
  const double beside = 0.5 * (columns(kWidth / 2 - 22, 20) + columns(kWidth / 2 + 2, 20));
  std::printf("%s: RMSE %.4f at the seam, %.4f beside it, %.2f times\n", name, seam, beside, seam / beside);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    Vase vase(glaze());
    const texmap::Image reference = vase.draw({.filter = render::Filter::kPoint, .supersampling = 8});
    const texmap::Image after = vase.draw({});
    // No area says any more that it comes round.
    scene::MeshView& mesh = vase.model.scene.meshes[0];
    std::vector<sweep::Area> areas(mesh.areas.begin(), mesh.areas.end());
    for (sweep::Area& area : areas) area.u_period = 0;
    mesh.areas = areas;
    const texmap::Image before = vase.draw({});
    report("before", before, reference);
    report("after", after, reference);
    if (argc > 1) {
      const std::filesystem::path folder = argv[1];
      write(folder / "seam_before.png", before);
      write(folder / "seam_after.png", after);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "seam: %s\n", error.what());
    return 1;
  }
}
