// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "scale_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>

#include "sweepkit/scene/output_file.hpp"
#include "sweepkit/texmap/image.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::report {

std::string knots_scene(double triangles, int objects, const std::string& image) {
  using Json = nlohmann::ordered_json;
  // Four times as many cells along the knot as round its tube.
  const double each = triangles / objects;
  const int round = std::max(3, static_cast<int>(std::round(std::sqrt(each / 8))));
  const int along = std::max(12, static_cast<int>(std::round(each / (2 * round))));
  Json scene = {{"sweepkit", 1},
                {"ambient", {0.2, 0.2, 0.2}},
                {"lights", {{{"directional", {-1, -2, -1}}, {"intensity", {0.7, 0.7, 0.7}}}}}};
  if (!image.empty()) scene["textures"]["image"] = {{"image", image}};
  scene["materials"]["surface"] = {{"diffuse", {0.8, 0.8, 0.8}}};
  if (!image.empty()) scene["materials"]["surface"]["texture"] = "image";
  const int columns = static_cast<int>(std::ceil(std::sqrt(objects)));
  for (int i = 0; i < objects; ++i) {
    scene["objects"].push_back(
        {{"name", "knot " + std::to_string(i)},
         {"material", "surface"},
         {"translate", {7.0 * (i % columns), 0, -7.0 * (i / columns)}},
         {"tessellation", {{"contour", round}, {"trajectory", along}}},
         {"sweep",
          {{"contour", {{"circle", {{"radius", 0.35}}}}},
           {"trajectory", {{"torus_knot", {{"p", 2}, {"q", 3}, {"radius", 2}, {"tube", 0.8}}}}}}}});
  }
  return scene.dump();
}

void write_noise(const std::filesystem::path& file, int side) {
  texmap::Image image = texmap::make_float_image(side, side);
  auto& texels = std::get<std::vector<float>>(image.texels);
  std::mt19937 random(1);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const float slope = static_cast<float>(i) / static_cast<float>(texels.size());
    texels[i] = 0.5f * slope + 0.5f * static_cast<float>(random() >> 8) * 0x1p-24f;
  }
  const std::vector<std::byte> bytes = texmap::encode_image(image, texmap::image_format(file));
  scene::write_files(std::vector<scene::OutputFile>{{file, bytes}});
}

}  // namespace sweepkit::report
